#include "app/explorer/difference.h"

#include "core/base/text.h"
#include "core/image/colour_difference.h"
#include "core/image/compare.h"
#include "core/image/flip.h"
#include "core/math/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reflectance::explorer {
namespace {

constexpr std::uint8_t noObject = 28; ///< sRGB code of the map beside the object

std::vector<std::size_t> coveredPixels(const Image& image)
{
    std::vector<std::size_t> covered;
    for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel)
        if (pixel < image.coverage.size() && image.coverage[pixel] > 0.0F)
            covered.push_back(pixel);
    return covered;
}

double largestOf(const Image& a, const Image& b, std::size_t pixel)
{
    double largest = 0.0;
    for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c)
        largest = std::fmax(largest, std::fabs(double{b.rgb[c]} - double{a.rgb[c]}));
    return largest;
}

/// A single spike would leave the rest of the map white: one pixel in a hundred may lie beyond the scale.
double scaleFor(const Image& a, const Image& b, const std::vector<std::size_t>& covered)
{
    std::vector<double> distances;
    distances.reserve(covered.size());
    for (const std::size_t pixel : covered)
        if (const double distance = largestOf(a, b, pixel); std::isfinite(distance))
            distances.push_back(distance);
    return roundScale(leastCovering(std::move(distances), 0.99));
}

Lab labAt(const Image& image, std::size_t pixel, float exposed)
{
    const float* rgb = &image.rgb[3 * pixel];
    const std::array<float, 3> shown{exposed * rgb[0], exposed * rgb[1], exposed * rgb[2]};
    return labOfDisplayed(shown.data());
}

/// As a display shows it.
Image exposedImage(Image image, float factor)
{
    for (float& value : image.rgb)
        value *= factor;
    return image;
}

double flipOver(const std::vector<std::size_t>& covered, const Image& a, const Image& b, float exposed)
{
    const std::vector<float> map = FlipReference(exposedImage(a, exposed)).mapOf(exposedImage(b, exposed));
    double sum = 0.0;
    for (const std::size_t pixel : covered)
        sum += static_cast<double>(map[pixel]);
    return covered.empty() ? 0.0 : sum / static_cast<double>(covered.size());
}

/// False where cancelled.
bool perceive(const Image& a, const Image& b, const std::vector<std::size_t>& covered, double exposure,
              DifferenceFigures& figures, Progress& progress)
{
    const auto exposed = static_cast<float>(std::exp2(exposure));
    std::vector<double> errors;
    errors.reserve(covered.size());
    for (const std::size_t pixel : covered) {
        if (progress.cancel)
            return false;
        errors.push_back(deltaE2000(labAt(a, pixel, exposed), labAt(b, pixel, exposed)));
    }
    figures.deltaEMax = errors.empty() ? 0.0 : *std::max_element(errors.begin(), errors.end());
    figures.deltaEP95 = leastCovering(std::move(errors), 0.95);
    figures.flipMean = flipOver(covered, a, b, exposed);
    return true;
}

/// Nothing where cancelled.
std::optional<DifferenceFigures> figuresOf(const Image& a, const Image& b, double exposure, bool perceived,
                                           Progress& progress)
{
    const auto metrics = compared(a, b);
    if (!metrics)
        return std::nullopt;
    const std::vector<std::size_t> covered = coveredPixels(a);
    DifferenceFigures figures;
    figures.identical = metrics->identical;
    figures.pixels = covered.size();
    figures.maxAbs = metrics->maxAbs;
    // Beside the object both show the same background: it takes part in the mean with zeros only.
    const auto share = static_cast<double>(std::max<std::size_t>(1, covered.size())) /
                       static_cast<double>(std::max<std::size_t>(1, a.pixels()));
    figures.rmse = metrics->rmse / std::sqrt(share);
    if (progress.cancel || (perceived && !perceive(a, b, covered, exposure, figures, progress)))
        return std::nullopt;
    return figures;
}

void paintBesideObject(const Image& a, std::vector<std::uint8_t>& rgb)
{
    for (std::size_t pixel = 0; pixel < a.pixels(); ++pixel)
        if (pixel >= a.coverage.size() || a.coverage[pixel] <= 0.0F)
            std::fill_n(rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel), 3, noObject);
}

} // namespace

double roundScale(double largest)
{
    if (!(largest > 0.0) || !std::isfinite(largest))
        return 1.0;
    const double decade = std::pow(10.0, std::floor(std::log10(largest)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * decade >= largest * (1.0 - 1e-12))
            return step * decade;
    return 10.0 * decade;
}

Image cropped(const Image& image, const Region& region)
{
    const auto pixel = [](double share, int size) {
        return std::clamp(static_cast<int>(std::lround(share * size)), 0, size);
    };
    const int left = std::min(pixel(region.left, image.width), image.width - 1);
    const int top = std::min(pixel(region.top, image.height), image.height - 1);
    const int width = std::max(1, pixel(region.right, image.width) - left);
    const int height = std::max(1, pixel(region.bottom, image.height) - top);
    Image part(width, height);
    for (int y = 0; y < height; ++y) {
        std::copy_n(image.at(left, top + y), 3 * static_cast<std::ptrdiff_t>(width), part.at(0, y));
        for (int x = 0; x < width && !image.coverage.empty(); ++x)
            part.coverage[Image::pixelCount(width, y) + static_cast<std::size_t>(x)] =
                image.coverage[Image::pixelCount(image.width, top + y) + static_cast<std::size_t>(left + x)];
    }
    return part;
}

std::optional<DifferencePicture> differenceOf(const Image& a, const Image& b, double exposure, bool perceived,
                                              Progress& progress, const std::optional<Region>& region)
{
    if (a.width != b.width || a.height != b.height)
        return std::nullopt;
    DifferencePicture picture;
    picture.width = a.width;
    picture.height = a.height;
    picture.scale = scaleFor(a, b, coveredPixels(a));
    picture.rgb = differenceMap(a, b, picture.scale);
    paintBesideObject(a, picture.rgb);
    const auto figures = region ? figuresOf(cropped(a, *region), cropped(b, *region), exposure, perceived, progress)
                                : figuresOf(a, b, exposure, perceived, progress);
    if (!figures)
        return std::nullopt;
    picture.figures = *figures;
    picture.figures.ofRegion = region.has_value();
    return picture;
}

std::string figuresText(const std::optional<DifferenceFigures>& figures)
{
    if (!figures)
        return "measuring\u2026";
    if (figures->pixels == 0)
        return "The object is out of the picture: nothing to compare.";
    if (figures->identical)
        return figures->ofRegion ? "Exactly equal in the rectangle: the difference is zero in every bit."
                                 : "A and B are exactly equal: the difference is zero in every bit.";
    std::string text = std::string(figures->ofRegion ? "Rectangle: " : "") + "RMSE " + general(figures->rmse, 3) +
                       ", largest " + general(figures->maxAbs, 3);
    if (figures->deltaEP95)
        text += ";  dE2000 p95 " + general(*figures->deltaEP95, 3) + ", largest " + general(*figures->deltaEMax, 3);
    if (figures->flipMean)
        text += ";  FLIP " + general(*figures->flipMean, 3);
    return text;
}

} // namespace reflectance::explorer
