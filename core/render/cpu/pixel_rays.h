// Camera rays through a picture's samples, with what all rays share computed once.
#pragma once

#include "core/geometry/camera.h"
#include "core/math/angle.h"
#include "core/render/settings.h"

namespace reflectance {

class PixelRays {
public:
    PixelRays(const Camera& camera, const RenderSettings& settings)
        : frame_(frameOf(camera)), settings_(settings),
          scale_(2.0 * std::tan(radians(camera.fieldOfView) / 2.0) / settings.height)
    {
    }

    /// rayThrough(x, y): unit direction from the eye through an image point in pixels.
    [[nodiscard]] Vec3d through(double x, double y) const
    {
        const double across = (x - 0.5 * settings_.width) * scale_;
        const double above = (0.5 * settings_.height - y) * scale_;
        return normalized(across * frame_.right + above * frame_.up - frame_.back);
    }

    /// Through sample s of a pixel; samples are numbered row by row on their k x k grid.
    [[nodiscard]] Vec3d throughSample(int pixelX, int pixelY, int s) const
    {
        const int k = settings_.samplesPerAxis;
        const int column = s % k;
        const int row = s / k;
        return through(pixelX + (column + 0.5) / k, pixelY + (row + 0.5) / k);
    }

private:
    CameraFrame frame_;
    RenderSettings settings_;
    double scale_;
};

} // namespace reflectance
