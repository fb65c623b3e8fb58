// A linear picture: radiance before the sensor, one float per channel.
#pragma once

#include <cstddef>
#include <vector>

namespace reflectance {

/// Rows from the top. `rgb` is linear and never clamped: negative and non-finite values stay for the sensor to count.
/// `coverage` is the share of a pixel's samples that met the object (0 .. 1); empty where a file gave none.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;      ///< 3 * width * height
    std::vector<float> coverage; ///< width * height, or empty

    Image() = default;
    Image(int w, int h) : width(w), height(h), rgb(3 * pixelCount(w, h), 0.0F), coverage(pixelCount(w, h), 0.0F) {}

    [[nodiscard]] static std::size_t pixelCount(int w, int h)
    {
        return static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
    }
    [[nodiscard]] std::size_t pixels() const { return pixelCount(width, height); }
    [[nodiscard]] const float* at(int x, int y) const
    {
        return &rgb[3 * (pixelCount(width, y) + static_cast<std::size_t>(x))];
    }
    [[nodiscard]] float* at(int x, int y) { return &rgb[3 * (pixelCount(width, y) + static_cast<std::size_t>(x))]; }
};

} // namespace reflectance
