#include "core/image/flip.h"

#include "core/base/check.h"
#include "core/image/colour_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;

using Plane = std::vector<float>;
using Taps = std::vector<float>; ///< odd in number, the middle one at offset 0

/// A picture in one channel.
struct Size {
    int width, height;
};

std::size_t radiusOf(const Taps& taps)
{
    return taps.size() / 2;
}

/// One row, with its ends repeated outwards.
void convolveRow(const float* from, int width, const Taps& taps, std::vector<float>& padded, float* to)
{
    const std::size_t radius = radiusOf(taps);
    const auto count = static_cast<std::size_t>(width);
    std::fill_n(padded.begin(), radius, from[0]);
    std::copy_n(from, count, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.begin() + static_cast<std::ptrdiff_t>(radius + count), radius, from[count - 1]);
    std::fill_n(to, count, 0.0F);
    for (std::size_t t = 0; t < taps.size(); ++t)
        for (std::size_t x = 0; x < count; ++x)
            to[x] += taps[t] * padded[x + t];
}

Plane alongRows(const Plane& plane, Size size, const Taps& taps)
{
    Plane result(plane.size());
    std::vector<float> padded(static_cast<std::size_t>(size.width) + 2 * radiusOf(taps));
    for (int y = 0; y < size.height; ++y) {
        const std::size_t row = Image::pixelCount(size.width, y);
        convolveRow(&plane[row], size.width, taps, padded, &result[row]);
    }
    return result;
}

Plane alongColumns(const Plane& plane, Size size, const Taps& taps)
{
    Plane result(plane.size(), 0.0F);
    const int radius = static_cast<int>(radiusOf(taps));
    const float* const middle = taps.data() + radius;
    for (int y = 0; y < size.height; ++y)
        for (int t = -radius; t <= radius; ++t) {
            const int source = std::clamp(y + t, 0, size.height - 1);
            const float tap = middle[t];
            const float* from = &plane[Image::pixelCount(size.width, source)];
            float* to = &result[Image::pixelCount(size.width, y)];
            for (int x = 0; x < size.width; ++x)
                to[x] += tap * from[x];
        }
    return result;
}

Plane convolved(const Plane& plane, Size size, const Taps& across, const Taps& down)
{
    return alongColumns(alongRows(plane, size, across), size, down);
}

template <class Function> Taps tapsOf(int radius, const Function& function)
{
    Taps taps;
    for (int i = -radius; i <= radius; ++i)
        taps.push_back(static_cast<float>(function(static_cast<double>(i))));
    return taps;
}

/// Positive taps made to sum to 1 and negative ones to -1.
Taps balanced(Taps taps)
{
    float positive = 0.0F;
    float negative = 0.0F;
    for (const float tap : taps)
        (tap > 0.0F ? positive : negative) += std::fabs(tap);
    for (float& tap : taps)
        tap /= tap > 0.0F ? positive : negative > 0.0F ? negative : 1.0F;
    return taps;
}

/// a exp(-pi^2 d^2 / b) at d degrees: a term of the eye's contrast sensitivity, in space. Table 1 of the paper.
struct Gaussian {
    double a, b;

    [[nodiscard]] double weight() const { return a * std::sqrt(pi / b); }
    [[nodiscard]] Taps taps(int radius, double pixelsPerDegree) const
    {
        return tapsOf(radius, [&](double i) {
            const double d = i / pixelsPerDegree;
            return std::exp(-pi * pi * d * d / b);
        });
    }
};
constexpr Gaussian achromatic{1.0, 0.0047}, redGreen{1.0, 0.0053}, blueYellow[2] = {{34.1, 0.04}, {13.5, 0.025}};

double sumOf(const Taps& taps)
{
    return std::accumulate(taps.begin(), taps.end(), 0.0);
}

Plane blurred(const Plane& plane, Size size, const Gaussian& gaussian, int radius, double pixelsPerDegree)
{
    const Taps taps = balanced(gaussian.taps(radius, pixelsPerDegree));
    return convolved(plane, size, taps, taps);
}

/// The blue-yellow filter is a sum of two Gaussians, each of which separates into rows and columns.
Plane blurredBlueYellow(const Plane& plane, Size size, int radius, double pixelsPerDegree)
{
    std::array<double, 2> volume{};
    std::array<Plane, 2> parts;
    for (std::size_t i = 0; i < 2; ++i) {
        const double sum = sumOf(blueYellow[i].taps(radius, pixelsPerDegree));
        volume[i] = blueYellow[i].weight() * sum * sum;
        parts[i] = blurred(plane, size, blueYellow[i], radius, pixelsPerDegree);
    }
    const auto share = static_cast<float>(volume[0] / (volume[0] + volume[1]));
    for (std::size_t i = 0; i < plane.size(); ++i)
        parts[0][i] = share * parts[0][i] + (1.0F - share) * parts[1][i];
    return std::move(parts[0]);
}

using Planes = std::array<Plane, 3>;

const Vec3d& whitePoint()
{
    static const Vec3d white = xyzOf({1.0, 1.0, 1.0});
    return white;
}

/// Y, red-green and blue-yellow, linear in the light: YCxCz.
Planes opponentsOf(const Image& image)
{
    Planes planes;
    for (Plane& plane : planes)
        plane.resize(image.pixels());
    const auto displayed = [](float c) { return c > 0.0F ? std::min(c, 1.0F) : 0.0F; };
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const float* rgb = &image.rgb[3 * i];
        const Vec3d xyz = xyzOf({displayed(rgb[0]), displayed(rgb[1]), displayed(rgb[2])});
        const Vec3d ratio{xyz.x / whitePoint().x, xyz.y / whitePoint().y, xyz.z / whitePoint().z};
        planes[0][i] = static_cast<float>(116.0 * ratio.y - 16.0);
        planes[1][i] = static_cast<float>(500.0 * (ratio.x - ratio.y));
        planes[2][i] = static_cast<float>(200.0 * (ratio.y - ratio.z));
    }
    return planes;
}

Vec3d clampedRgb(const Vec3d& xyz)
{
    const auto kept = [](double c) { return std::clamp(c, 0.0, 1.0); };
    return {kept(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z),
            kept(-0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z),
            kept(0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z)};
}

/// Chroma counts less in the dark (Hunt's effect).
Lab adjusted(const Lab& lab)
{
    return {lab.L, 0.01 * lab.L * lab.a, 0.01 * lab.L * lab.b};
}

/// HyAB, which suits large differences, compressed by 0.7.
double colourDistance(const Lab& one, const Lab& other)
{
    return std::pow(std::fabs(one.L - other.L) + std::hypot(one.a - other.a, one.b - other.b), 0.7);
}

/// What the eye keeps of the colours at this distance.
std::vector<Lab> perceivedColours(const Planes& opponents, Size size, double pixelsPerDegree)
{
    const int radius =
        static_cast<int>(std::ceil(3.0 * std::sqrt(blueYellow[0].b / (2.0 * pi * pi)) * pixelsPerDegree));
    const Plane Y = blurred(opponents[0], size, achromatic, radius, pixelsPerDegree);
    const Plane cx = blurred(opponents[1], size, redGreen, radius, pixelsPerDegree);
    const Plane cz = blurredBlueYellow(opponents[2], size, radius, pixelsPerDegree);
    std::vector<Lab> colours(Y.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const double y = (double{Y[i]} + 16.0) / 116.0;
        const Vec3d xyz{(y + double{cx[i]} / 500.0) * whitePoint().x, y * whitePoint().y,
                        (y - double{cz[i]} / 200.0) * whitePoint().z};
        colours[i] = adjusted(labOf(xyzOf(clampedRgb(xyz)), whitePoint()));
    }
    return colours;
}

/// How strong edges and points are, at the width to which the eye is most sensitive.
struct Features {
    Plane edges, points;
};

Plane magnitudes(const Plane& plane, Size size, const Taps& detector, const Taps& smooth)
{
    Plane x = convolved(plane, size, detector, smooth);
    const Plane y = convolved(plane, size, smooth, detector);
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = std::hypot(x[i], y[i]);
    return x;
}

Features featuresOf(Plane brightness, Size size, double pixelsPerDegree)
{
    for (float& b : brightness)
        b = (b + 16.0F) / 116.0F;
    const double deviation = 0.5 * 0.082 * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const auto bell = [&](double i) { return std::exp(-0.5 * i * i / (deviation * deviation)); };
    const Taps smooth = balanced(tapsOf(radius, bell));
    const Taps edge = balanced(tapsOf(radius, [&](double i) { return -i * bell(i); }));
    const Taps point =
        balanced(tapsOf(radius, [&](double i) { return (i * i / (deviation * deviation) - 1.0) * bell(i); }));
    return {magnitudes(brightness, size, edge, smooth), magnitudes(brightness, size, point, smooth)};
}

/// The colour distance mapped to 0 .. 1: 0.95 is reached at two fifths of the largest.
double errorOf(double distance)
{
    static const double largest = colourDistance(adjusted(labOf(xyzOf({0, 1, 0}), whitePoint())),
                                                 adjusted(labOf(xyzOf({0, 0, 1}), whitePoint())));
    const double knee = 0.4 * largest;
    return distance < knee ? 0.95 / knee * distance : 0.95 + 0.05 * (distance - knee) / (largest - knee);
}

} // namespace

struct FlipReference::Prepared {
    Size size;
    double pixelsPerDegree;
    std::vector<Lab> colours;
    Features features;

    Prepared(const Image& image, double resolution) : size{image.width, image.height}, pixelsPerDegree(resolution)
    {
        Planes opponents = opponentsOf(image);
        colours = perceivedColours(opponents, size, pixelsPerDegree);
        features = featuresOf(std::move(opponents[0]), size, pixelsPerDegree);
    }
};

FlipReference::FlipReference(const Image& reference, double pixelsPerDegree)
    : prepared_(std::make_unique<Prepared>(reference, pixelsPerDegree))
{
}
FlipReference::~FlipReference() = default;
FlipReference::FlipReference(FlipReference&&) noexcept = default;
FlipReference& FlipReference::operator=(FlipReference&&) noexcept = default;

std::vector<float> FlipReference::mapOf(const Image& test) const
{
    CHECK_EQ(test.width, prepared_->size.width);
    CHECK_EQ(test.height, prepared_->size.height);
    const Prepared other(test, prepared_->pixelsPerDegree);
    const auto difference = [](const Plane& a, const Plane& b, std::size_t i) { return std::fabs(a[i] - b[i]); };
    std::vector<float> map(test.pixels());
    for (std::size_t i = 0; i < map.size(); ++i) {
        const double colour = errorOf(colourDistance(prepared_->colours[i], other.colours[i]));
        const double feature = std::max(difference(prepared_->features.edges, other.features.edges, i),
                                        difference(prepared_->features.points, other.features.points, i));
        map[i] = static_cast<float>(std::pow(colour, 1.0 - std::sqrt(feature / std::numbers::sqrt2)));
    }
    return map;
}

double FlipReference::meanOf(const Image& test) const
{
    const std::vector<float> map = mapOf(test);
    return map.empty() ? 0.0 : std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

} // namespace reflectance
