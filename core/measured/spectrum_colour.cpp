#include "core/measured/spectrum_colour.h"

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/spectra/builtin.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr double first = 380.0; ///< nm
constexpr double last = 730.0;
constexpr double step = 10.0;

/// Adds `weight` at a wavelength, shared between the two neighbours in proportion.
void spread(std::vector<Vec3d>& weights, std::span<const double> wavelengths, double at, const Vec3d& weight)
{
    const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), at);
    if (above == wavelengths.begin() || above == wavelengths.end()) {
        (above == wavelengths.begin() ? weights.front() : weights.back()) += weight;
        return;
    }
    const auto i = static_cast<std::size_t>(above - wavelengths.begin());
    const double t = (at - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
    weights[i - 1] += weight * (1.0 - t);
    weights[i] += weight * t;
}

} // namespace

Vec3d linearFromXyz(const Vec3d& xyz)
{
    return {3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
            0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
}

std::vector<Vec3d> colourWeights(std::span<const double> wavelengths)
{
    CHECK_LT(std::size_t{0}, wavelengths.size());
    std::vector<Vec3d> weights(wavelengths.size());
    const auto D65 = lightNamed("D65");
    CHECK_EQ(static_cast<bool>(D65), true); // the program carries it
    const SpectrumTriple& observer = standardObserver();
    Vec3d white;
    for (double nm = first; nm <= last; nm += step) {
        const Vec3d rgb =
            linearFromXyz(D65->at(nm) * Vec3d(observer[0].at(nm), observer[1].at(nm), observer[2].at(nm)));
        white += rgb;
        spread(weights, wavelengths, nm, rgb);
    }
    // D65 is sRGB's white up to the four digits of the matrix: white is made exact.
    for (Vec3d& weight : weights)
        weight = {weight.x / white.x, weight.y / white.y, weight.z / white.z};
    return weights;
}

Result<std::vector<Vec3d>> weightsFor(std::span<const double> wavelengths, std::optional<double> chosen)
{
    if (!chosen)
        return colourWeights(wavelengths);
    CHECK_LT(std::size_t{0}, wavelengths.size());
    if (!(*chosen >= wavelengths.front() && *chosen <= wavelengths.back()))
        return Error{"was measured from " + general(wavelengths.front(), 6) + " to " + general(wavelengths.back(), 6) +
                     " nm; choose a wavelength there, not " + general(*chosen, 6) + " nm"};
    std::vector<Vec3d> weights(wavelengths.size());
    spread(weights, wavelengths, *chosen, Vec3d(1.0));
    return weights;
}

} // namespace reflectance
