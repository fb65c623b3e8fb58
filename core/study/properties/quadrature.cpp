#include "core/study/properties/quadrature.h"

#include "core/study/properties/basis.h"

#include <algorithm>
#include <numbers>

namespace reflectance::properties {
namespace {

constexpr double pi = std::numbers::pi;

struct Legendre {
    double value, slope;
};

/// P_n and its derivative by the three-term recurrence; |x| < 1.
Legendre legendre(int n, double x)
{
    double before = 1.0;
    double value = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k;
        before = value;
        value = next;
    }
    return {value, n * (x * value - before) / (x * x - 1.0)};
}

/// How far from T a circle at this polar angle reaches before it meets the horizon; 0 if it lies below.
double reach(double lean, double polar)
{
    const double height = std::cos(lean) * std::cos(polar);
    const double swing = std::sin(lean) * std::sin(polar);
    if (height >= swing)
        return pi;
    return height <= -swing ? 0.0 : std::acos(-height / swing);
}

std::vector<double> breaks(const HemisphereGrid& grid)
{
    std::vector<double> found{0.0, pi / 2.0 - grid.lean, pi / 2.0 + grid.lean, grid.rim};
    for (double polar = pi / 2.0; polar > 0.5e-4; polar /= 2.0)
        found.push_back(polar);
    std::sort(found.begin(), found.end());
    const auto last = std::upper_bound(found.begin(), found.end(), pi / 2.0 + grid.lean);
    found.erase(last, found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

} // namespace

GaussLegendre gaussLegendre(int order)
{
    GaussLegendre rule;
    for (int i = 0; i < order; ++i) {
        double x = std::cos(pi * (i + 0.75) / (order + 0.5));
        for (int step = 0; step < 8; ++step) { // Newton doubles the digits: four steps do, from this start
            const Legendre p = legendre(order, x);
            x -= p.value / p.slope;
        }
        const double slope = legendre(order, x).slope;
        rule.x.push_back(0.5 * (1.0 + x));
        rule.weight.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

std::vector<WeightedDirection> hemisphere(const HemisphereGrid& grid, int order)
{
    const GaussLegendre gauss = gaussLegendre(order);
    // T leans towards N, so a circle that dips below the horizon loses its far end, where the azimuth is pi.
    const Basis about = basisAbout({std::sin(grid.lean), 0.0, std::cos(grid.lean)}, {0, 0, 1});
    const std::vector<double> rings = breaks(grid);
    std::vector<WeightedDirection> directions;
    for (std::size_t ring = 1; ring < rings.size(); ++ring)
        for (std::size_t i = 0; i < gauss.x.size(); ++i) {
            // sin^2 is flat at both ends, which smooths the roots that `reach` has where a circle meets the horizon.
            const double width = rings[ring] - rings[ring - 1];
            const double bend = std::sin(0.5 * pi * gauss.x[i]);
            const double polar = rings[ring - 1] + width * bend * bend;
            const double stretch = width * 0.5 * pi * std::sin(pi * gauss.x[i]) * gauss.weight[i];
            const double end = reach(grid.lean, polar);
            for (std::size_t k = 0; k < gauss.x.size() && end > 0.0; ++k)
                for (const double side : {-1.0, 1.0})
                    directions.push_back({directionIn(about, polar, side * end * gauss.x[k]),
                                          std::sin(polar) * stretch * end * gauss.weight[k]});
        }
    return directions;
}

std::vector<WeightedDirection> uprightHemisphere(double rim, int order)
{
    const GaussLegendre gauss = gaussLegendre(order);
    std::vector<double> rings{0.0, rim, pi / 2.0};
    for (double elevation = pi / 4.0; elevation > 1e-3; elevation /= 2.0)
        rings.push_back(pi / 2.0 - elevation);
    std::sort(rings.begin(), rings.end());
    std::vector<WeightedDirection> directions;
    const Basis about{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    for (std::size_t ring = 1; ring < rings.size(); ++ring)
        for (std::size_t i = 0; i < gauss.x.size(); ++i) {
            const double width = rings[ring] - rings[ring - 1];
            const double polar = rings[ring - 1] + width * gauss.x[i];
            const double weight = std::sin(polar) * width * gauss.weight[i] * pi / 2.0;
            for (const double quarter : {0.0, 1.0, 2.0, 3.0})
                for (std::size_t k = 0; k < gauss.x.size(); ++k)
                    directions.push_back(
                        {directionIn(about, polar, (quarter + gauss.x[k]) * pi / 2.0), weight * gauss.weight[k]});
        }
    return directions;
}

} // namespace reflectance::properties
