// A coarse picture spread over a finer one.
#pragma once

#include "core/image/image.h"

namespace reflectance {

/// Bilinear between the centres of the coarse pixels; beyond the outermost centres their values stay. Sizes need not be
/// multiples of each other.
[[nodiscard]] Image upscaled(const Image& coarse, int width, int height);

} // namespace reflectance
