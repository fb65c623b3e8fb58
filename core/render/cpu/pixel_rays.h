// Camera rays through a picture's samples, with what all rays share computed once.
#pragma once

#include "core/geometry/camera.h"
#include "core/math/angle.h"
#include "core/render/settings.h"

namespace reflectance {

class PixelRays {
public:
    /// What all rays share.
    struct Frame {
        Vec3d eye, right, up, back;
        double middleX, middleY; ///< of the picture, in pixels
        double scale;            ///< a pixel's edge at distance 1
    };

    PixelRays(const Camera& camera, const RenderSettings& settings)
        : frame_(frameFor(camera, settings)), samplesPerAxis_(settings.samplesPerAxis)
    {
    }

    [[nodiscard]] const Frame& frame() const { return frame_; }

    /// rayThrough(x, y): unit direction from the eye through an image point in pixels.
    [[nodiscard]] Vec3d through(double x, double y) const
    {
        const double across = (x - frame_.middleX) * frame_.scale;
        const double above = (frame_.middleY - y) * frame_.scale;
        return normalized(across * frame_.right + above * frame_.up - frame_.back);
    }

    /// The image point of column or row i of a pixel's k x k samples, in pixels.
    [[nodiscard]] double place(int pixel, int i) const { return pixel + (i + 0.5) / samplesPerAxis_; }

    /// Through sample s of a pixel; samples are numbered row by row on their k x k grid.
    [[nodiscard]] Vec3d throughSample(int pixelX, int pixelY, int s) const
    {
        return through(place(pixelX, s % samplesPerAxis_), place(pixelY, s / samplesPerAxis_));
    }

private:
    static Frame frameFor(const Camera& camera, const RenderSettings& settings)
    {
        const CameraFrame axes = frameOf(camera);
        return {camera.eye,
                axes.right,
                axes.up,
                axes.back,
                0.5 * settings.width,
                0.5 * settings.height,
                2.0 * std::tan(radians(camera.fieldOfView) / 2.0) / settings.height};
    }

    Frame frame_;
    int samplesPerAxis_;
};

} // namespace reflectance
