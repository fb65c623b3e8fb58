// Two pictures of one size in one.
#pragma once

#include "core/image/image.h"

namespace reflectance {

/// a, a gap of black, b; the sizes must match.
[[nodiscard]] Image sideBySide(const Image& a, const Image& b, int gap);

/// a's columns left of `divider` (its share of the width, 0 .. 1), b's from there on; the sizes must match.
[[nodiscard]] Image wiped(const Image& a, const Image& b, double divider);

} // namespace reflectance
