#include "core/spectra/metamers.h"

#include "core/spectra/color_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace reflectance {
namespace {

using Values = std::vector<double>;

double product(const ColorSystem& system, const Values& a, const Values& b)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
        sum += system.grid.weight[k] * a[k] * b[k];
    return sum;
}

/// Takes from `values` what lies along the directions, which are orthonormal; twice, since once leaves roundings behind.
void free(const ColorSystem& system, const std::vector<Values>& directions, Values& values)
{
    for (int pass = 0; pass < 2; ++pass)
        for (const Values& direction : directions) {
            const double along = product(system, direction, values);
            for (std::size_t k = 0; k < values.size(); ++k)
                values[k] -= along * direction[k];
        }
}

/// What the nine integrals of M look at, made orthonormal; fewer where a filter does not see a primary.
std::vector<Values> seenDirections(const ColorSystem& system)
{
    std::vector<Values> directions;
    for (const Values& sensor : system.sensors)
        for (const Values& primary : system.primaries) {
            Values seen(system.grid.size());
            for (std::size_t k = 0; k < seen.size(); ++k)
                seen[k] = primary[k] * sensor[k] / system.grid.weight[k]; // sensors hold the weight
            const double before = std::sqrt(product(system, seen, seen));
            free(system, directions, seen);
            const double after = std::sqrt(product(system, seen, seen));
            if (!(after > 1e-9 * before))
                continue;
            for (double& value : seen)
                value /= after;
            directions.push_back(std::move(seen));
        }
    return directions;
}

/// The largest strength, of either sign, with which S + strength * black stays within 0 .. 1.
double strongest(const Values& S, const Values& black)
{
    double up = std::numeric_limits<double>::infinity();
    double down = up;
    for (std::size_t k = 0; k < S.size(); ++k) {
        const double above = std::max(0.0, 1.0 - S[k]);
        const double below = std::max(0.0, S[k]);
        if (black[k] > 0.0) {
            up = std::min(up, above / black[k]);
            down = std::min(down, below / black[k]);
        } else if (black[k] < 0.0) {
            up = std::min(up, below / -black[k]);
            down = std::min(down, above / -black[k]);
        }
    }
    const double strength = up >= down ? up : -down;
    return std::isfinite(strength) ? strength : 0.0;
}

} // namespace

std::vector<double> metamericTwin(const ColorSystem& system, const std::vector<double>& S)
{
    constexpr double period = 90.0; // nm: finer than the filters, coarser than what real pigments do
    Values black(system.grid.size());
    for (std::size_t k = 0; k < black.size(); ++k)
        black[k] = std::cos(2.0 * std::numbers::pi * (system.grid.nm[k] - 550.0) / period);
    free(system, seenDirections(system), black);
    const double strength = strongest(S, black);
    Values twin = S;
    for (std::size_t k = 0; k < twin.size(); ++k)
        twin[k] = std::clamp(S[k] + strength * black[k], std::min(S[k], 0.0), std::max(S[k], 1.0));
    return twin;
}

MetamericPair metamericPair(const ColorSystem& system, const Mat3d& toXyz, const JudgedSurface& surface,
                            const JudgedLight& light)
{
    MetamericPair pair;
    pair.twin = metamericTwin(system, surface.S);
    const Vec3d white = system.W * Vec3d(1.0);
    const Vec3d own = surface.M * Vec3d(1.0);
    const Vec3d twin = system.M(pair.twin) * Vec3d(1.0);
    pair.ownUnderWhite = displayed(toXyz, own, white);
    pair.twinUnderWhite = displayed(toXyz, twin, white);
    pair.apartUnderWhite = colorError(toXyz, own, twin, white).deltaE;
    const Vec3d ownLit = system.response(light.power, surface.S);
    const Vec3d twinLit = system.response(light.power, pair.twin);
    pair.ownUnderLight = displayed(toXyz, ownLit, light.white);
    pair.twinUnderLight = displayed(toXyz, twinLit, light.white);
    pair.apartUnderLight = colorError(toXyz, ownLit, twinLit, light.white).deltaE;
    return pair;
}

} // namespace reflectance
