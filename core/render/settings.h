// How large and how finely a picture is rendered: nothing here changes what it shows.
#pragma once

#include "core/base/result.h"

#include <cstddef>

namespace reflectance {

/// Samples lie on a regular grid inside each pixel, at ((i+1/2)/k, (j+1/2)/k): the same places in both renderers.
struct RenderSettings {
    int width = 1024;
    int height = 1024;
    int samplesPerAxis = 2; ///< k: k^2 samples per pixel, 1 .. 8

    /// Of the whole picture.
    [[nodiscard]] std::size_t samples() const
    {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(samplesPerAxis) * static_cast<std::size_t>(samplesPerAxis);
    }

    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

/// Refuses sizes outside 1 .. 16384 and sample counts other than 1, 4, 9, ... 64: k^2 samples lie on a regular grid.
[[nodiscard]] Result<RenderSettings> checkedSettings(int width, int height, int samplesPerPixel);

} // namespace reflectance
