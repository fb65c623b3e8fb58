#include "core/study/lens/lens.h"

#include "core/math/quantile.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/study/lens/half.h"
#include "core/study/lens/passive_angles.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

constexpr double smallestNormal = 0x1p-126;

Image throughHalf(Image image)
{
    std::ranges::transform(image.rgb, image.rgb.begin(), roundedToHalf);
    return image;
}

template <class Holds> bool anyChannel(const float* rgb, Holds holds)
{
    return holds(rgb[0]) || holds(rgb[1]) || holds(rgb[2]);
}

LensPixel judged(const float* exact, const float* got, double most, bool abovePassive)
{
    const auto isNaN = [](float c) { return std::isnan(c); };
    const auto isInfinite = [](float c) { return std::isinf(c); };
    const auto isNegative = [](float c) { return c < 0.0F; };
    LensPixel pixel;
    pixel.digits = static_cast<float>(std::min(
        {digitsKept(exact[0], got[0], most), digitsKept(exact[1], got[1], most), digitsKept(exact[2], got[2], most)}));
    pixel.mark = anyChannel(got, isNaN)                                         ? LensMark::NotANumber
                 : anyChannel(got, isInfinite)                                  ? LensMark::Infinite
                 : anyChannel(got, isNegative) || anyChannel(exact, isNegative) ? LensMark::Negative
                 : abovePassive                                                 ? LensMark::AbovePassive
                                                                                : LensMark::Digits;
    return pixel;
}

} // namespace

std::string_view nameOf(LensKind kind)
{
    constexpr std::string_view names[] = {"float", "half", "simd", "glsl"};
    return names[static_cast<int>(kind)];
}

double mostDigits(LensKind kind)
{
    return (kind == LensKind::Half ? 11.0 : 24.0) * std::log10(2.0);
}

double digitsKept(double exact, double got, double most)
{
    const bool nothing = std::fabs(exact) < smallestNormal;
    if (exact == got || (nothing && std::fabs(got) < smallestNormal))
        return most;
    if (nothing || !std::isfinite(exact) || !std::isfinite(got))
        return 0.0;
    return std::clamp(-std::log10(std::fabs(got - exact) / std::fabs(exact)), 0.0, most);
}

Image shadedFor(LensKind kind, const ViewSamples& samples, const Scene& scene, Progress* progress)
{
    const Precision precision = kind == LensKind::Simd ? Precision::Simd : Precision::Float;
    Image image = shadeSamples(samples, scene, precision, progress);
    return kind == LensKind::Half ? throughHalf(std::move(image)) : image;
}

std::optional<LensMap> lensMap(LensKind kind, const ViewSamples& samples, const Image& image, const Scene& scene,
                               Progress& progress)
{
    const Image exact = shadeSamples(samples, scene, Precision::Double, &progress);
    const PassiveAngles passive(scene, progress);
    if (progress.cancel)
        return std::nullopt;
    const auto whole = static_cast<std::uint32_t>(samples.settings.samplesPerAxis * samples.settings.samplesPerAxis);
    LensMap map{image.width, image.height, std::vector<LensPixel>(image.pixels())};
    for (std::size_t pixel = 0; pixel < map.pixels.size(); ++pixel) {
        const std::uint32_t first = samples.firstOfPixel[pixel];
        const std::uint32_t last = samples.firstOfPixel[pixel + 1];
        // A pixel that the object covers in part also shows the background, which no model computes.
        if (last - first == whole)
            map.pixels[pixel] = judged(&exact.rgb[3 * pixel], &image.rgb[3 * pixel], mostDigits(kind),
                                       passive.exceededAt(samples, first));
    }
    return map;
}

LensFigures figuresOf(const LensMap& map)
{
    LensFigures figures;
    std::vector<double> digits;
    for (const LensPixel& pixel : map.pixels) {
        figures.covered += pixel.mark == LensMark::Background ? 0 : 1;
        figures.notANumber += pixel.mark == LensMark::NotANumber ? 1 : 0;
        figures.infinite += pixel.mark == LensMark::Infinite ? 1 : 0;
        figures.negative += pixel.mark == LensMark::Negative ? 1 : 0;
        figures.abovePassive += pixel.mark == LensMark::AbovePassive ? 1 : 0;
        if (pixel.mark == LensMark::Digits)
            digits.push_back(pixel.digits);
    }
    if (digits.empty())
        return figures;
    figures.fewest = *std::min_element(digits.begin(), digits.end());
    figures.median = medianOf(std::move(digits));
    return figures;
}

} // namespace reflectance
