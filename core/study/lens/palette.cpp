#include "core/study/lens/palette.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

/// At 0, 1 .. 7 digits.
constexpr std::array<Rgb8, 8> ramp{{{255, 246, 205},
                                    {250, 219, 130},
                                    {238, 181, 92},
                                    {209, 140, 92},
                                    {165, 108, 104},
                                    {116, 84, 115},
                                    {70, 62, 112},
                                    {26, 40, 84}}};

constexpr Rgb8 nothing{24, 24, 24};
constexpr Rgb8 hatch{0, 0, 0};

Rgb8 colorOfMark(LensMark mark)
{
    switch (mark) {
    case LensMark::NotANumber:
        return {255, 0, 200};
    case LensMark::Infinite:
        return {255, 255, 255};
    case LensMark::Negative:
        return {0, 190, 255};
    case LensMark::AbovePassive:
        return {70, 220, 90};
    case LensMark::Background:
    case LensMark::Digits:
        break;
    }
    return nothing;
}

} // namespace

Rgb8 colorOfDigits(double digits)
{
    const double place = std::clamp(digits, 0.0, static_cast<double>(ramp.size() - 1));
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, ramp.size() - 1);
    Rgb8 color{};
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = static_cast<std::uint8_t>(
            std::lround(std::lerp(1.0 * ramp[low][i], 1.0 * ramp[high][i], place - std::floor(place))));
    return color;
}

Rgb8 colorOf(const LensPixel& pixel, int x, int y)
{
    if (pixel.mark == LensMark::Digits)
        return colorOfDigits(pixel.digits);
    if (pixel.mark != LensMark::Background && (x + y) % 5 == 0)
        return hatch;
    return colorOfMark(pixel.mark);
}

const std::array<LensLegend, 4>& lensLegend()
{
    static constexpr std::array<LensLegend, 4> legend{{
        {LensMark::NotANumber, "NaN", "The value is not a number in this arithmetic."},
        {LensMark::Infinite, "infinite", "The value is beyond the largest number of this arithmetic."},
        {LensMark::Negative, "negative", "The formula's value is below 0: no light is; the sensor shows black."},
        {LensMark::AbovePassive, "above passive",
         "A light comes from an angle at which the surface sends on more than arrives."},
    }};
    return legend;
}

std::vector<std::uint8_t> painted(const LensMap& map)
{
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * map.pixels.size());
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const Rgb8 color = colorOf(map.at(x, y), x, y);
            rgb.insert(rgb.end(), color.begin(), color.end());
        }
    return rgb;
}

} // namespace reflectance
