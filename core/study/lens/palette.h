// The lens' colours, the same in pictures, in the window and in its legend.
#pragma once

#include "core/study/lens/lens.h"

#include <array>

namespace reflectance {

using Rgb8 = std::array<std::uint8_t, 3>;

/// 0 digits is light, all of a float's is dark: lightness alone orders them, so that no kind of colour vision mixes
/// them up.
[[nodiscard]] Rgb8 colorOfDigits(double digits);

/// Marks are told from digits by hatching, too: every fifth diagonal is black. x and y choose the place in it.
[[nodiscard]] Rgb8 colorOf(const LensPixel& pixel, int x, int y);

/// One line of the legend.
struct LensLegend {
    LensMark mark;
    const char* name;  ///< "NaN"
    const char* about; ///< one sentence
};
[[nodiscard]] const std::array<LensLegend, 4>& lensLegend();

/// 8-bit RGB, rows from the top. Where there is nothing but background, dark grey.
[[nodiscard]] std::vector<std::uint8_t> painted(const LensMap& map);

} // namespace reflectance
