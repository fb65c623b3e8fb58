// Micro-surfaces made by rule.
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/study/goniometer/counter_random.h"
#include "core/study/goniometer/surface_makers.h"

#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

constexpr double steepest = 85.0; ///< degrees
constexpr int slopesOfSigma = 32;

Patch groove(double slope)
{
    const double heights[] = {0.0, 0.5 * std::tan(slope)};
    return heightField(2, 1, heights, 1.0, 1.0);
}

/// Quantiles (k + 1/2) / count of the density exp(-a^2 / 2 sigma^2) sin a over 0 .. 90 degrees, radians.
std::vector<double> slopesAt(double sigma, int count)
{
    constexpr int steps = 20000;
    const double h = std::numbers::pi / 2.0 / steps;
    std::vector<double> below{0.0}; // by the midpoint rule
    for (int i = 0; i < steps; ++i) {
        const double a = (i + 0.5) * h;
        below.push_back(below.back() + std::exp(-0.5 * a * a / (sigma * sigma)) * std::sin(a));
    }
    std::vector<double> slopes;
    std::size_t at = 0;
    for (int k = 0; k < count; ++k) {
        const double wanted = below.back() * (k + 0.5) / count;
        while (below[at + 1] < wanted)
            ++at;
        slopes.push_back(h * (static_cast<double>(at) + (wanted - below[at]) / (below[at + 1] - below[at])));
    }
    return slopes;
}

std::vector<double> noise(std::size_t count, CounterRandom random)
{
    std::vector<double> normal;
    while (normal.size() < count) { // Box and Muller 1958
        const double radius = std::sqrt(-2.0 * std::log1p(-random.next()));
        const double angle = 2.0 * std::numbers::pi * random.next();
        normal.push_back(radius * std::cos(angle));
        normal.push_back(radius * std::sin(angle));
    }
    normal.resize(count);
    return normal;
}

/// Convolves each row with exp(-2 (x / correlation)^2), periodic: white noise then has the correlation exp(-(x / correlation)^2).
void smoothRows(std::vector<double>& heights, std::size_t columns, double correlation)
{
    const auto reach = static_cast<std::ptrdiff_t>(std::min(2.2 * correlation, 0.5) * static_cast<double>(columns));
    std::vector<double> weights;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
        const double x = static_cast<double>(k) / static_cast<double>(columns) / correlation;
        weights.push_back(std::exp(-2.0 * x * x));
    }
    const auto count = static_cast<std::ptrdiff_t>(columns);
    std::vector<double> row(columns);
    for (std::size_t first = 0; first < heights.size(); first += columns) {
        for (std::ptrdiff_t x = 0; x < count; ++x) {
            double sum = 0.0;
            for (std::ptrdiff_t k = -reach; k <= reach; ++k)
                sum += weights[static_cast<std::size_t>(k + reach)] *
                       heights[first + static_cast<std::size_t>((x + k + count) % count)];
            row[static_cast<std::size_t>(x)] = sum;
        }
        std::copy(row.begin(), row.end(), heights.begin() + static_cast<std::ptrdiff_t>(first));
    }
}

std::vector<double> transposedGrid(const std::vector<double>& heights, std::size_t side)
{
    std::vector<double> turned(heights.size());
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x)
            turned[x * side + y] = heights[y * side + x];
    return turned;
}

struct Roughness {
    double slope = 0.0; ///< standard deviation along a line, as a tangent
    double correlation = 0.0;
    std::size_t cells = 0;
    std::uint64_t seed = 1;
};

Result<Roughness> roughnessFrom(std::string_view text, double cells, double mostCells, double correlation)
{
    const auto words = SurfaceWords::parsed(text, {"sigma", "correlation", "cells", "seed"});
    if (!words)
        return words.error();
    const auto sigma = words->number("sigma", 20.0, 0.01, 60.0);
    const auto extent = words->number("correlation", correlation, 0.001, 0.25);
    const auto count = words->number("cells", cells, 8.0, mostCells);
    const auto seed = words->number("seed", 1.0, 0.0, 1e9);
    for (const auto* number : {&sigma, &extent, &count, &seed})
        if (!*number)
            return number->error();
    if (*extent * std::floor(*count) < 2.0)
        return Error{"correlation " + general(*extent, 4) + " is below two of " + general(*count, 6) +
                     " cells; give more cells or a larger correlation"};
    return Roughness{std::tan(radians(*sigma)), *extent, static_cast<std::size_t>(*count),
                     static_cast<std::uint64_t>(*seed)};
}

/// Heights scaled so that the facets have the root mean square slope asked for exactly.
Patch withSlope(std::vector<double> heights, std::size_t columns, std::size_t rows, double slope)
{
    const double scale = slope / rmsSlope(heightField(columns, rows, heights, 1.0, 1.0));
    for (double& height : heights)
        height *= scale;
    return heightField(columns, rows, heights, 1.0, 1.0);
}

} // namespace

Result<std::vector<Patch>> makeFlat(std::string_view words)
{
    if (!words.empty())
        return Error{"a flat surface has nothing to choose; write flat alone"};
    const double height[] = {0.0};
    return std::vector{heightField(1, 1, height, 1.0, 1.0)};
}

Result<std::vector<Patch>> makeVGrooves(std::string_view text)
{
    const auto words = SurfaceWords::parsed(text, {"slope", "sigma"});
    if (!words)
        return words.error();
    if (words->has("slope") == words->has("sigma"))
        return Error{"grooves have either one slope or a sigma; write vgrooves:slope=30 or vgrooves:sigma=30"};
    const auto angle =
        words->has("slope") ? words->number("slope", 0.0, 0.01, steepest) : words->number("sigma", 0.0, 0.01, 60.0);
    if (!angle)
        return angle.error();
    if (words->has("slope"))
        return std::vector{groove(radians(*angle))};
    std::vector<Patch> grooves;
    for (const double slope : slopesAt(radians(*angle), slopesOfSigma))
        grooves.push_back(groove(std::min(slope, radians(steepest))));
    return grooves;
}

Result<std::vector<Patch>> makeGaussian(std::string_view text)
{
    const auto rough = roughnessFrom(text, 256.0, 1024.0, 0.05);
    if (!rough)
        return rough.error();
    const std::size_t side = rough->cells;
    std::vector<double> heights = noise(side * side, CounterRandom(rough->seed, 0, 0));
    smoothRows(heights, side, rough->correlation);
    heights = transposedGrid(heights, side);
    smoothRows(heights, side, rough->correlation);
    return std::vector{withSlope(std::move(heights), side, side, std::numbers::sqrt2 * rough->slope)};
}

Result<std::vector<Patch>> makeScratches(std::string_view text)
{
    const auto rough = roughnessFrom(text, 1024.0, 16384.0, 0.02);
    if (!rough)
        return rough.error();
    std::vector<double> heights = noise(rough->cells, CounterRandom(rough->seed, 0, 0));
    smoothRows(heights, rough->cells, rough->correlation);
    return std::vector{withSlope(std::move(heights), rough->cells, 1, rough->slope)};
}

} // namespace reflectance
