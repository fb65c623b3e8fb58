#include "core/spectra/color_price.h"

#include "core/base/check.h"
#include "core/image/colour_difference.h"
#include "core/math/quantile.h"
#include "core/spectra/builtin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reflectance {
namespace {

Vec3d clipped(const Vec3d& v)
{
    return {std::max(v.x, 0.0), std::max(v.y, 0.0), std::max(v.z, 0.0)};
}

double largest(const Vec3d& v)
{
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// Column vector times row vector, added.
void addOuter(Mat3d& sum, const Vec3d& column, const Vec3d& row)
{
    sum.rows[0] += column.x * row;
    sum.rows[1] += column.y * row;
    sum.rows[2] += column.z * row;
}

std::vector<double> mixed(const ColorSystem& system, const Vec3d& strengths)
{
    std::vector<double> power(system.grid.size());
    for (std::size_t k = 0; k < power.size(); ++k)
        power[k] = strengths.x * system.primaries[0][k] + strengths.y * system.primaries[1][k] +
                   strengths.z * system.primaries[2][k];
    return power;
}

void priceOne(CheatPrice& price, const ColorError& error, std::size_t surface, std::size_t light)
{
    price.each.push_back(error.deltaE);
    price.maxLinear = std::max(price.maxLinear, error.linear);
    price.negative += error.negative;
    if (error.deltaE > price.max) {
        price.max = error.deltaE;
        price.worstSurface = surface;
        price.worstLight = light;
    }
}

} // namespace

std::string_view nameOf(Cheat cheat)
{
    constexpr std::string_view names[] = {"full", "best_diagonal", "diagonal_of_m", "dropped", "white"};
    return names[static_cast<std::size_t>(cheat)];
}

std::string_view wordsFor(Cheat cheat)
{
    constexpr std::string_view words[] = {"full K", "best diagonal", "diagonal of M", "off-diagonals of K dropped",
                                          "colour under white"};
    return words[static_cast<std::size_t>(cheat)];
}

std::vector<JudgedLight> lightsInSpan(const ColorSystem& system)
{
    constexpr std::pair<const char*, Vec3d> strengths[] = {
        {"white", {1.0, 1.0, 1.0}},         {"warm", {1.0, 0.75, 0.5}},           {"cool", {0.6, 0.8, 1.0}},
        {"saturated red", {1.0, 0.2, 0.2}}, {"saturated green", {0.2, 1.0, 0.2}}, {"saturated blue", {0.2, 0.2, 1.0}},
        {"pure red", {1.0, 0.0, 0.0}},      {"pure green", {0.0, 1.0, 0.0}},      {"pure blue", {0.0, 0.0, 1.0}}};
    std::vector<JudgedLight> lights;
    for (const auto& [name, I] : strengths)
        lights.push_back({name, true, mixed(system, I), system.W * I, system.W * Vec3d(1.0)});
    return lights;
}

JudgedLight judgedLight(const ColorSystem& system, const Spectrum& light)
{
    JudgedLight judged{light.name, false, sampledOn(system.grid, light), {}, {}};
    const double brightest = largest(system.response(judged.power, {}));
    for (double& power : judged.power) // a light's unit is its own: the brightest channel sees 1
        power = brightest > 0.0 ? power / brightest : power;
    judged.seen = system.response(judged.power, {});
    judged.white = judged.seen;
    return judged;
}

JudgedSurface judgedSurface(const ColorSystem& system, const Spectrum& reflectance)
{
    JudgedSurface surface{reflectance.name, sampledOn(system.grid, reflectance), {}, {}, {}};
    surface.M = system.M(surface.S);
    surface.K = system.K(surface.S, Convention::Sensor);
    surface.bestDiagonal = bestDiagonalOf(system, surface, Convention::Sensor);
    return surface;
}

Vec3d bestDiagonalOf(const ColorSystem& system, const JudgedSurface& surface, Convention convention)
{
    const Mat3d fromSeen = inverse(system.W);
    Vec3d above, below;
    for (const JudgedLight& light : lightsInSpan(system)) {
        const Vec3d I = convention == Convention::Sensor ? light.seen : fromSeen * light.seen;
        above += (surface.K * light.seen) * I;
        below += I * I;
    }
    return {above.x / below.x, above.y / below.y, above.z / below.z};
}

Mat3d matrixBy(Cheat cheat, const ColorSystem& system, const JudgedSurface& surface)
{
    switch (cheat) {
    case Cheat::FullK:
        return surface.K;
    case Cheat::BestDiagonal:
        return diagonalMatrix(surface.bestDiagonal);
    case Cheat::DiagonalOfM:
        return diagonalMatrix(diagonalOf(surface.M)) * inverse(system.W);
    case Cheat::DroppedOffDiagonals:
        return diagonalMatrix(diagonalOf(surface.K));
    case Cheat::ColorUnderWhite:
        break;
    }
    return diagonalMatrix(surface.K * Vec3d(1.0));
}

Mat3d xyzFromSensor(const ColorSystem& system)
{
    const std::vector<double> white = mixed(system, Vec3d(1.0));
    std::array<std::vector<double>, 3> observer;
    for (std::size_t c = 0; c < 3; ++c) {
        observer[c] = sampledOn(system.grid, standardObserver()[c]);
        for (std::size_t k = 0; k < system.grid.size(); ++k)
            observer[c][k] *= system.grid.weight[k] * white[k];
    }
    // Normal equations: C (sum of r r^T) = sum of t r^T. Well conditioned: 24 colours, three unknowns a row.
    Mat3d squares, products;
    for (const Spectrum& patch : colorChecker()) {
        const std::vector<double> S = sampledOn(system.grid, patch);
        const Vec3d r = system.response(white, S);
        const auto seen = [&S](const std::vector<double>& o) {
            return std::inner_product(S.begin(), S.end(), o.begin(), 0.0);
        };
        addOuter(squares, r, r);
        addOuter(products, {seen(observer[0]), seen(observer[1]), seen(observer[2])}, r);
    }
    return products * inverse(squares);
}

ColorError colorError(const Mat3d& toXyz, const Vec3d& truth, const Vec3d& cheat, const Vec3d& white)
{
    const Vec3d fitted = toXyz * white;
    const double least = 1e-6 * largest(fitted); // a fit may leave a strange lamp's white without X or Z
    const Vec3d under{std::max(fitted.x, least), std::max(fitted.y, least), std::max(fitted.z, least)};
    const auto labFrom = [&](const Vec3d& response) { return labOf(clipped(toXyz * clipped(response)), under); };
    ColorError error;
    error.deltaE = deltaE2000(labFrom(truth), labFrom(cheat));
    error.linear = largest(cheat - truth) / largest(white);
    error.negative = cheat.x < 0.0 || cheat.y < 0.0 || cheat.z < 0.0;
    return error;
}

std::vector<CheatPrice> pricesOfCheats(const ColorSystem& system, const std::vector<JudgedSurface>& surfaces,
                                       const std::vector<JudgedLight>& lights)
{
    const Mat3d toXyz = xyzFromSensor(system);
    std::vector<CheatPrice> prices;
    for (const Cheat cheat : allCheats) {
        CheatPrice price;
        price.cheat = cheat;
        for (std::size_t l = 0; l < lights.size(); ++l)
            for (std::size_t s = 0; s < surfaces.size(); ++s) {
                const Vec3d truth = system.response(lights[l].power, surfaces[s].S);
                const Vec3d made = matrixBy(cheat, system, surfaces[s]) * lights[l].seen;
                priceOne(price, colorError(toXyz, truth, made, lights[l].white), s, l);
            }
        if (!price.each.empty()) {
            price.mean =
                std::accumulate(price.each.begin(), price.each.end(), 0.0) / static_cast<double>(price.each.size());
            price.p95 = quantileOf(price.each, 0.95);
        }
        prices.push_back(std::move(price));
    }
    return prices;
}

} // namespace reflectance
