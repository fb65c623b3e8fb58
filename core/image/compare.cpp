#include "core/image/compare.h"

#include "core/base/check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

namespace reflectance {
namespace {

OddPixels oddPixels(const Image& image)
{
    OddPixels counts;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const auto begin = image.rgb.begin() + static_cast<std::ptrdiff_t>(i);
        counts.negative += std::any_of(begin, begin + 3, [](float c) { return c < 0.0F; });
        counts.nonFinite += std::any_of(begin, begin + 3, [](float c) { return !std::isfinite(c); });
    }
    return counts;
}

bool sameBits(float a, float b)
{
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

double distanceOf(float a, float b)
{
    if (sameBits(a, b) || (std::isnan(a) && std::isnan(b)))
        return 0.0;
    const double difference = std::fabs(double{b} - double{a});
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

double luminance(const float* rgb)
{
    return 0.2126 * double{rgb[0]} + 0.7152 * double{rgb[1]} + 0.0722 * double{rgb[2]};
}

using Codes = std::array<double, 3>;

/// Blue - white - red, told apart under the common colour deficiencies, lightness falling evenly to both sides.
Codes divergingColour(double t)
{
    constexpr Codes white{247, 247, 247};
    constexpr Codes middle[2] = {{103, 169, 207}, {239, 138, 98}};
    constexpr Codes end[2] = {{20, 80, 155}, {165, 20, 40}};
    const std::size_t side = t < 0.0 ? 0 : 1;
    const double amount = 2.0 * std::min(std::fabs(t), 1.0);
    const Codes& from = amount < 1.0 ? white : middle[side];
    const Codes& to = amount < 1.0 ? middle[side] : end[side];
    const double share = amount < 1.0 ? amount : amount - 1.0;
    Codes colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = from[c] + share * (to[c] - from[c]);
    return colour;
}

} // namespace

Result<Comparison> compared(const Image& a, const Image& b)
{
    if (a.width != b.width || a.height != b.height)
        return Error{"the pictures differ in size: " + std::to_string(a.width) + " x " + std::to_string(a.height) +
                     " against " + std::to_string(b.width) + " x " + std::to_string(b.height) +
                     "; render both at one size"};
    Comparison result;
    result.identical = std::equal(a.rgb.begin(), a.rgb.end(), b.rgb.begin(), b.rgb.end(), sameBits);
    double sum = 0.0;
    double squares = 0.0;
    std::size_t worst = 0;
    for (std::size_t pixel = 0; pixel < a.pixels(); ++pixel) {
        bool differs = false;
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
            const double distance = distanceOf(a.rgb[i], b.rgb[i]);
            sum += distance;
            squares += distance * distance;
            differs = differs || distance > 0.0;
            const double magnitude = std::max(std::fabs(double{a.rgb[i]}), relativeFloor);
            // inf / inf: a finite value against an infinite one is infinitely far in relation, too.
            result.maxRelative = std::max(result.maxRelative, std::isinf(distance) ? distance : distance / magnitude);
            if (distance > result.maxAbs) {
                result.maxAbs = distance;
                worst = i;
            }
        }
        result.differing += differs;
    }
    const auto width = static_cast<std::size_t>(std::max(a.width, 1));
    result.x = static_cast<int>(worst / 3 % width);
    result.y = static_cast<int>(worst / 3 / width);
    result.channel = static_cast<int>(worst % 3);
    const auto count = static_cast<double>(std::max<std::size_t>(a.rgb.size(), 1));
    result.meanAbs = sum / count;
    result.rmse = std::sqrt(squares / count);
    result.a = oddPixels(a);
    result.b = oddPixels(b);
    return result;
}

std::vector<std::uint8_t> differenceMap(const Image& a, const Image& b, double scale)
{
    CHECK_EQ(a.rgb.size(), b.rgb.size());
    CHECK_LT(0.0, scale);
    std::vector<std::uint8_t> codes(a.rgb.size(), 0);
    for (std::size_t i = 0; i < codes.size(); i += 3) {
        const double t = (luminance(&b.rgb[i]) - luminance(&a.rgb[i])) / scale;
        if (std::isnan(t))
            continue;
        const Codes colour = divergingColour(t);
        for (std::size_t c = 0; c < 3; ++c)
            codes[i + c] = static_cast<std::uint8_t>(std::lround(colour[c]));
    }
    return codes;
}

} // namespace reflectance
