#include "core/measured/facts.h"

#include "core/math/angle.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;

double meanOf(const Mat3d& f)
{
    const Vec3d sum = f * Vec3d(1.0);
    return (sum.x + sum.y + sum.z) / 3.0;
}

/// Sums of squares and largest values of differences and of what they are differences of.
struct Spread {
    double squares = 0.0, ownSquares = 0.0, worst = 0.0, largest = 0.0;
    std::size_t count = 0;

    void add(double difference, double own, double weight = 1.0)
    {
        squares += weight * difference * difference;
        ownSquares += weight * own * own;
        worst = std::max(worst, std::fabs(difference));
        largest = std::max(largest, std::fabs(own));
        ++count;
    }

    [[nodiscard]] double rms() const { return ownSquares > 0.0 ? std::sqrt(squares / ownSquares) : 0.0; }
    [[nodiscard]] double relativeWorst() const { return largest > 0.0 ? worst / largest : 0.0; }
};

std::vector<double> evenThetas(std::size_t steps)
{
    std::vector<double> theta;
    for (std::size_t i = 0; i < steps; ++i)
        theta.push_back(pi / 2.0 * static_cast<double>(i) / static_cast<double>(steps));
    return theta;
}

ReciprocityMap mapAt(const Measurement& measurement, double deltaPhi, std::vector<double> theta, Spread& spread)
{
    ReciprocityMap map{std::move(theta), deltaPhi, {}};
    for (const double thetaI : map.theta)
        for (const double thetaR : map.theta) {
            const Vec3d L = directionAt(thetaI, 0.0);
            const Vec3d V = directionAt(thetaR, deltaPhi);
            const auto there = brdfAt(measurement, L, V);
            const auto back = brdfAt(measurement, V, L);
            map.residual.push_back(std::numeric_limits<double>::quiet_NaN());
            if (!there || !back)
                continue;
            map.residual.back() = meanOf(*there) - meanOf(*back);
            const double weight = 0.25 * std::sin(2.0 * thetaI) * std::sin(2.0 * thetaR);
            spread.add(map.residual.back(), 0.5 * (meanOf(*there) + meanOf(*back)), weight);
        }
    return map;
}

struct Integral {
    Vec3d value;
    double known = 0.0;
};

/// Over the hemisphere, cosine included, by the midpoint rule in sin^2(theta_r) and azimuth: exact for a constant. The
/// azimuths begin at the plane of incidence, half a step off, and the kinks of a table make higher orders useless.
Integral integrated(const Measurement& measurement, const Vec3d& L, std::size_t order)
{
    Integral integral;
    const std::size_t azimuths = 2 * order;
    for (std::size_t i = 0; i < order; ++i) {
        const double squared = (static_cast<double>(i) + 0.5) / static_cast<double>(order);
        const double radius = std::sqrt(squared);
        Integral circle; // sums of sums round less than one long sum
        for (std::size_t j = 0; j < azimuths; ++j) {
            const double phi = 2.0 * pi * (static_cast<double>(j) + 0.5) / static_cast<double>(azimuths);
            const Vec3d V{radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1.0 - squared)};
            if (const auto f = brdfAt(measurement, L, V)) {
                circle.value += *f * Vec3d(1.0);
                circle.known += 1.0;
            }
        }
        integral.value += circle.value;
        integral.known += circle.known;
    }
    const double cells = static_cast<double>(order * azimuths);
    return {integral.value * (pi / cells), integral.known / cells};
}

/// Of a very large table, a hundred thousand samples are asked.
LeftOut leftOutAlong(const Table& table, std::size_t axis)
{
    Spread spread;
    std::size_t stride = 1;
    for (std::size_t later = axis + 1; later < table.axes.size(); ++later)
        stride *= table.axes[later].size();
    const std::size_t count = table.axes[axis].size();
    constexpr std::size_t asked = 100000;
    for (std::size_t sample = 0; sample < table.samples(); sample += 1 + table.samples() / asked) {
        const std::size_t place = sample / stride % count;
        if (place == 0 || place + 1 == count || table.isHole(sample))
            continue;
        // A table over this axis alone, without the sample; two steps to either side are all that interpolation reads.
        Table line;
        line.channels = table.channels;
        line.interpolation = table.interpolation;
        line.axes = {{}, {0.0}};
        const std::size_t first = place >= 2 ? place - 2 : 0;
        const std::size_t last = std::min(place + 2, count - 1);
        for (std::size_t at = first; at <= last; ++at) {
            if (at == place)
                continue;
            line.axes[0].push_back(table.axes[axis][at]);
            const double* const values = &table.values[(sample + at * stride - place * stride) * table.channels];
            line.values.insert(line.values.end(), values, values + table.channels);
        }
        const std::size_t before = place - 1 - first;
        if (line.isHole(before) || line.isHole(before + 1))
            continue;
        const auto told = valueAt(line, {table.axes[axis][place], 0.0, 0.0});
        for (std::size_t c = 0; told && c < table.channels; ++c)
            spread.add((*told)[c] - table.values[sample * table.channels + c],
                       table.values[sample * table.channels + c]);
    }
    return {std::string(angleNames(table.system)[axis]), spread.rms(), spread.relativeWorst(),
            spread.count / table.channels};
}

LeftOut leftOutOf(const ScatteredBrdf& brdf)
{
    Spread spread;
    for (std::size_t sample = 0; sample < brdf.points.size(); ++sample)
        if (const auto told = leftOut(brdf, sample))
            for (std::size_t c = 0; c < brdf.channels; ++c) {
                const double own = brdf.values[sample * brdf.channels + c];
                spread.add((*told)[c] - own, own);
            }
    return {"all", spread.rms(), spread.relativeWorst(), spread.count / brdf.channels};
}

} // namespace

ReciprocityMap reciprocityMap(const Measurement& measurement, double deltaPhi, std::size_t steps)
{
    Spread spread;
    ReciprocityMap map = mapAt(measurement, deltaPhi, evenThetas(steps), spread);
    map.rms = spread.rms();
    map.worst = spread.relativeWorst();
    return map;
}

Reciprocity reciprocityOf(const Measurement& measurement, double limit)
{
    std::vector<double> theta = evenThetas(18);
    std::erase_if(theta, [limit](double angle) { return angle > limit + 1e-9; });
    Spread spread;
    for (int degrees = 0; degrees <= 180; degrees += 15)
        (void)mapAt(measurement, radians(degrees), theta, spread);
    return {limit, spread.rms(), spread.relativeWorst(), spread.count};
}

Albedo albedoAt(const Measurement& measurement, double thetaI)
{
    const Vec3d L = directionAt(thetaI, 0.0);
    const bool isSlow = std::holds_alternative<ScatteredBrdf>(measurement); // and smooth between its samples
    const std::size_t finest = isSlow ? 48 : 192;
    Integral integral = integrated(measurement, L, finest / 4);
    double change = 0.0;
    for (std::size_t order = finest / 2; order <= finest; order *= 2) {
        const Integral finer = integrated(measurement, L, order);
        const Vec3d step = finer.value - integral.value;
        change = std::max({std::fabs(step.x), std::fabs(step.y), std::fabs(step.z)});
        integral = finer;
        if (change < 1e-6)
            break;
    }
    return {thetaI, integral.value, integral.known, change};
}

std::vector<LeftOut> leaveOneOut(const Measurement& measurement)
{
    std::vector<LeftOut> found;
    if (const auto* table = std::get_if<Table>(&measurement))
        for (std::size_t axis = 0; axis < table->axes.size(); ++axis)
            found.push_back(leftOutAlong(*table, axis));
    if (const auto* scattered = std::get_if<ScatteredBrdf>(&measurement))
        found.push_back(leftOutOf(*scattered));
    return found;
}

} // namespace reflectance
