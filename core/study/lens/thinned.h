// Fewer samples of a view, where all of them would take too long.
#pragma once

#include "core/image/image.h"
#include "core/render/view_samples.h"

#include <cstddef>
#include <vector>

namespace reflectance {

/// The pixels where these columns and rows cross, as a smaller view.
[[nodiscard]] ViewSamples crossings(const ViewSamples& samples, const std::vector<int>& columns,
                                    const std::vector<int>& rows);

/// Where the squares of a grid of `stride` pixels have their middles, along an edge of `size` pixels.
[[nodiscard]] std::vector<int> middles(int size, int stride);

/// The pixels in the middles of such squares, as a smaller view.
[[nodiscard]] ViewSamples everyNth(const ViewSamples& samples, int stride);
[[nodiscard]] Image everyNth(const Image& image, int stride);

/// The same samples in one row, a pixel for each: shading them gives every sample's own value.
[[nodiscard]] ViewSamples eachAPixel(ViewSamples samples);

} // namespace reflectance
