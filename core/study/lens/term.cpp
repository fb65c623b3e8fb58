#include "core/study/lens/term.h"

#include "core/base/text.h"
#include "core/study/lens/half.h"
#include "core/study/lens/sensitivity.h"
#include "core/study/lens/suspects.h"
#include "core/study/lens/thinned.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

/// Below this magnification a handful of roundings is all that happens.
constexpr double harmless = 16.0;
/// Fewer digits lost than this need no culprit: a few units in the last place.
constexpr double unnoticed = 0.8;
/// A suspect names one path of the rounding; kappa sums the components of all vectors, up to this many times as much.
constexpr double pathsInKappa = 16.0;

/// The largest of the channels' ratios; 0 where there is no value.
double kappaOf(const Vec3d& slope, const Vec3d& value)
{
    const auto ratio = [](double s, double v) { return s > 0.0 && v != 0.0 ? s / std::fabs(v) : 0.0; };
    return std::max({ratio(slope.x, value.x), ratio(slope.y, value.y), ratio(slope.z, value.z)});
}

std::size_t mostSensitive(const Sensitivity& found)
{
    std::size_t worst = 0;
    for (std::size_t i = 1; i < found.value.size(); ++i)
        if (kappaOf(found.all(i), found.value[i]) > kappaOf(found.all(worst), found.value[worst]))
            worst = i;
    return worst;
}

/// Where no place of the formula is known to be guilty: the input that moves the value most.
std::string mostMoving(const Sensitivity& found, std::size_t sample)
{
    constexpr const char* names[] = {"the normal N", "the viewer V", "the lights' L and I", "the parameters"};
    std::size_t most = 0;
    for (std::size_t input = 1; input < std::size(names); ++input)
        if (kappaOf(found.of[input][sample], found.value[sample]) >
            kappaOf(found.of[most][sample], found.value[sample]))
            most = input;
    return std::string("the formula magnifies the rounding of ") + names[most] + " " +
           general(kappaOf(found.of[most][sample], found.value[sample]), 2) + " times";
}

/// What the store of a picture in half precision does to a value.
std::string storeTerm(const Vec3d& exact)
{
    const double largest = std::max({std::fabs(exact.x), std::fabs(exact.y), std::fabs(exact.z)});
    const double smallest = std::min({std::fabs(exact.x), std::fabs(exact.y), std::fabs(exact.z)});
    if (largest >= 65520.0)
        return "the largest half is 65504";
    if (smallest < smallestNormalHalf)
        return "below 6.1e-5 half numbers lose bits";
    return {};
}

std::string termOf(LensKind kind, const LensReading& reading, const Sensitivity& found, std::size_t sample,
                   std::vector<Suspect> suspects)
{
    if (kind == LensKind::Half)
        if (std::string words = storeTerm(reading.exact); !words.empty())
            return words;
    std::ranges::sort(suspects, std::greater<>(), &Suspect::magnifies);
    const bool lost = reading.pixel.mark != LensMark::Digits || reading.pixel.digits < mostDigits(kind) - unnoticed;
    if (!lost || reading.kappa <= harmless)
        return kind == LensKind::Half ? "a half number has 11 bits" : "nothing but a few roundings";
    const bool known = !suspects.empty() && suspects.front().magnifies * pathsInKappa >= reading.kappa;
    return known ? suspects.front().words : mostMoving(found, sample);
}

} // namespace

LensReading readingAt(LensKind kind, const LensMap& map, const ViewSamples& samples, const Image& image,
                      const Scene& scene, int x, int y)
{
    LensReading reading;
    reading.pixel = map.at(x, y);
    const ViewSamples here = crossings(samples, {x}, {y});
    if (here.count() == 0)
        return reading;
    const Sensitivity found = sensitivityOf(here, scene);
    for (const Vec3d& value : found.value)
        reading.exact += value / static_cast<double>(here.count());
    reading.got = {image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]};
    const std::size_t worst = mostSensitive(found);
    reading.kappa = kappaOf(found.all(worst), found.value[worst]);
    reading.term = termOf(kind, reading, found, worst, suspectsAt(here, worst, scene));
    return reading;
}

} // namespace reflectance
