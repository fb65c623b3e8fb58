#include "core/measured/spectrum_colour.h"

#include "core/base/check.h"
#include "core/base/text.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr double first = 380.0; ///< nm
constexpr double step = 10.0;

/// CIE D65 (relative power) and the CIE 1931 2-degree observer xbar, ybar, zbar at 380, 390 ... 730 nm.
struct Row {
    double d65, x, y, z;
};
constexpr Row observer[] = {
    {49.9755, 0.001368, 3.9e-05, 0.00645}, {54.6482, 0.004243, 0.00012, 0.02005}, {82.7549, 0.01431, 0.000396, 0.06785},
    {91.486, 0.04351, 0.00121, 0.2074},    {93.4318, 0.13438, 0.004, 0.6456},     {86.6823, 0.2839, 0.0116, 1.3856},
    {104.865, 0.34828, 0.023, 1.74706},    {117.008, 0.3362, 0.038, 1.77211},     {117.812, 0.2908, 0.06, 1.6692},
    {114.861, 0.19536, 0.09098, 1.28764},  {115.923, 0.09564, 0.13902, 0.81295},  {108.811, 0.03201, 0.20802, 0.46518},
    {109.354, 0.0049, 0.323, 0.272},       {107.802, 0.0093, 0.503, 0.1582},      {104.79, 0.06327, 0.71, 0.07825},
    {107.689, 0.1655, 0.862, 0.04216},     {104.405, 0.2904, 0.954, 0.0203},      {104.046, 0.43345, 0.99495, 0.00875},
    {100, 0.5945, 0.995, 0.0039},          {96.3342, 0.7621, 0.952, 0.0021},      {95.788, 0.9163, 0.87, 0.00165},
    {88.6856, 1.0263, 0.757, 0.0011},      {90.0062, 1.0622, 0.631, 0.0008},      {89.5991, 1.0026, 0.503, 0.00034},
    {87.6987, 0.85445, 0.381, 0.00019},    {83.2886, 0.6424, 0.265, 5e-05},       {83.6992, 0.4479, 0.175, 2e-05},
    {80.0268, 0.2835, 0.107, 0},           {80.2146, 0.1649, 0.061, 0},           {82.2778, 0.0874, 0.032, 0},
    {78.2842, 0.04677, 0.017, 0},          {69.7213, 0.0227, 0.00821, 0},         {71.6091, 0.0113592, 0.004102, 0},
    {74.349, 0.00579035, 0.002091, 0},     {61.604, 0.00289933, 0.001047, 0},     {69.8856, 0.00143997, 0.00052, 0},
};

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
    double at = first;
    Vec3d white;
    for (const Row& row : observer) {
        const Vec3d rgb = linearFromXyz(row.d65 * Vec3d(row.x, row.y, row.z));
        white += rgb;
        spread(weights, wavelengths, at, rgb);
        at += step;
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
