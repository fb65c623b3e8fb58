// Camera rays through a picture's samples, with what all rays share computed once.
#pragma once

#include "core/geometry/camera.h"
#include "core/math/angle.h"
#include "core/render/settings.h"

#include <array>

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

    /// The same for eight pixels, four to the right and two down from (left, top): to the same bit, all of one number at
    /// a time, so that the compiler makes vectors of it.
    void throughBlock(int left, int top, int s, std::array<double, 8>& dx, std::array<double, 8>& dy,
                      std::array<double, 8>& dz) const
    {
        const int k = settings_.samplesPerAxis;
        const double offsetX = (s % k + 0.5) / k;
        const double offsetY = (s / k + 0.5) / k;
        for (int i = 0; i < 8; ++i) {
            const auto ray = static_cast<std::size_t>(i);
            const double across = (left + i % 4 + offsetX - 0.5 * settings_.width) * scale_;
            const double above = (0.5 * settings_.height - (top + i / 4 + offsetY)) * scale_;
            const double x = across * frame_.right.x + above * frame_.up.x - frame_.back.x;
            const double y = across * frame_.right.y + above * frame_.up.y - frame_.back.y;
            const double z = across * frame_.right.z + above * frame_.up.z - frame_.back.z;
            const double size = std::sqrt(x * x + y * y + z * z); // from 1 on, for `back` is unit and at right angles
            dx[ray] = x / size;
            dy[ray] = y / size;
            dz[ray] = z / size;
        }
    }

private:
    CameraFrame frame_;
    RenderSettings settings_;
    double scale_;
};

} // namespace reflectance
