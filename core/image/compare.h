// What separates two pictures, in numbers and as a map. Both are linear.
#pragma once

#include "core/base/result.h"
#include "core/image/image.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace reflectance {

/// Pixels of one picture that no display can show as they are.
struct OddPixels {
    std::size_t negative = 0;  ///< with a channel below 0
    std::size_t nonFinite = 0; ///< with a NaN or infinite channel
};

/// Differences b - a over all channels. A channel that is bitwise equal counts as 0, also where both are the same
/// infinity or both NaN; any other pair with a non-finite value makes the figures infinite.
struct Comparison {
    bool identical = false; ///< every channel has the same bits
    double maxAbs = 0.0;
    int x = 0, y = 0, channel = 0; ///< where maxAbs is first met, rows from the top
    double meanAbs = 0.0;
    double rmse = 0.0;
    double maxRelative = 0.0;  ///< |b - a| / max(|a|, relativeFloor)
    std::size_t differing = 0; ///< pixels with any difference
    OddPixels a, b;
};

/// Below this magnitude of the first picture, relative differences are taken against it instead: a thousandth of white.
inline constexpr double relativeFloor = 1e-3;

/// Refuses pictures of different size.
[[nodiscard]] Result<Comparison> compared(const Image& a, const Image& b);

/// The signed difference of luminance (Rec. 709 weights), b - a, as 8-bit sRGB codes: white where equal, towards blue
/// where b is darker, towards red where it is brighter, full colour from `scale` on. Pixels with NaN are black.
/// The sizes must match.
[[nodiscard]] std::vector<std::uint8_t> differenceMap(const Image& a, const Image& b, double scale);

} // namespace reflectance
