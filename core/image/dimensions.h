// What a picture file may claim before memory is given to it. For the readers of this room.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>

namespace reflectance {

inline constexpr long largestSide = 65536;
inline constexpr long mostPixels = 1L << 27; ///< a 16384 x 8192 surroundings picture; 1.6 GB as linear values

/// Refuses sizes outside 1 .. largestSide, above mostPixels, or that `bytes` cannot hold at `pixelsPerByte`, the best
/// that the format's compression can do: a damaged header of a small file must not ask for gigabytes.
[[nodiscard]] Result<void> checkDimensions(long width, long height, std::size_t bytes, long pixelsPerByte,
                                           const std::string& path);

} // namespace reflectance
