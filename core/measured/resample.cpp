#include "core/measured/resample.h"

#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/measured/merl.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double hole = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t chunk = 4096;

double largestStep(const std::vector<double>& axis)
{
    double largest = 0.0;
    for (std::size_t i = 1; i < axis.size(); ++i)
        largest = std::max(largest, axis[i] - axis[i - 1]);
    return largest;
}

/// Keeps the azimuth; nothing where the direction lies too far below the surface.
std::optional<Vec3d> raised(const Vec3d& d, double lowest)
{
    static const double rim = std::sin(radians(0.5));
    if (d.z >= rim)
        return d;
    if (d.z < lowest)
        return std::nullopt;
    const double across = std::hypot(d.x, d.y);
    const double scale = std::sqrt(1.0 - rim * rim) / across;
    return Vec3d{d.x * scale, d.y * scale, rim};
}

/// The pair at a grid's sample, raised.
std::optional<DirectionPair> pairAt(const GridShape& shape, std::size_t sample, double lowest)
{
    Angles at{};
    for (std::size_t axis = shape.axes.size(); axis-- > 0;) {
        at[axis] = shape.axes[axis][sample % shape.axes[axis].size()];
        sample /= shape.axes[axis].size();
    }
    const DirectionPair pair = directionsAt(shape.system, at);
    const auto L = raised(pair.L, lowest);
    const auto V = raised(pair.V, lowest);
    return L && V ? std::optional(DirectionPair{*L, *V}) : std::nullopt;
}

void appendChannels(std::vector<double>& values, const Mat3d& f, std::size_t channels)
{
    const auto& [r, g, b] = f.rows;
    if (channels == 1)
        values.push_back(r.x);
    else if (channels == 3)
        values.insert(values.end(), {r.x, g.y, b.z});
    else
        values.insert(values.end(), {r.x, r.y, r.z, g.x, g.y, g.z, b.x, b.y, b.z});
}

/// f where a pair is asked for; the mean of both ways where a pair and its reverse are one and the same to the table.
std::vector<std::optional<Mat3d>> valuesAt(const std::vector<std::optional<DirectionPair>>& asked,
                                           const BrdfFunction& f, bool bothWays)
{
    std::vector<DirectionPair> pairs;
    for (const auto& pair : asked)
        if (pair)
            pairs.push_back(*pair);
    auto values = f(pairs);
    if (bothWays) {
        for (DirectionPair& pair : pairs)
            std::swap(pair.L, pair.V);
        const auto back = f(pairs);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!values[i])
                values[i] = back[i];
            else if (back[i])
                for (std::size_t row = 0; row < 3; ++row)
                    values[i]->rows[row] = 0.5 * (values[i]->rows[row] + back[i]->rows[row]);
        }
    }
    std::vector<std::optional<Mat3d>> result;
    auto next = values.begin();
    for (const auto& pair : asked)
        result.push_back(pair ? *next++ : std::nullopt);
    return result;
}

/// The radical inverse of i in a base: the i-th point of a sequence that fills 0 .. 1 evenly.
double halton(std::size_t i, std::size_t base)
{
    double result = 0.0;
    double digit = 1.0;
    for (; i > 0; i /= base) {
        digit /= static_cast<double>(base);
        result += digit * static_cast<double>(i % base);
    }
    return result;
}

Vec3d cosineDirection(double u, double v)
{
    const double radius = std::sqrt(u);
    return {radius * std::cos(2.0 * pi * v), radius * std::sin(2.0 * pi * v), std::sqrt(1.0 - u)};
}

std::vector<DirectionPair> probes()
{
    static const double lowest = std::sin(radians(2.0));
    std::vector<DirectionPair> pairs;
    for (std::size_t i = 1; pairs.size() < 4096; ++i) {
        DirectionPair pair{cosineDirection(halton(i, 2), halton(i, 3)), cosineDirection(halton(i, 5), halton(i, 7))};
        if (i % 2 == 0) { // V near the mirror direction: H near N
            const double u = halton(i, 5);
            const Vec3d H = directionAt(radians(30.0) * u * u, 2.0 * pi * halton(i, 7));
            pair.V = 2.0 * dot(H, pair.L) * H - pair.L;
        }
        if (pair.L.z > lowest && pair.V.z > lowest)
            pairs.push_back(pair);
    }
    return pairs;
}

double meanOf(const Mat3d& f)
{
    const Vec3d sum = f * Vec3d(1.0);
    return (sum.x + sum.y + sum.z) / 3.0;
}

} // namespace

std::size_t GridShape::samples() const
{
    std::size_t product = 1;
    for (const auto& axis : axes)
        product *= axis.size();
    return product;
}

GridShape polarShape(std::size_t thetas)
{
    const auto theta = merl::evenNodes(thetas - 1, pi / 2.0);
    return {AngleSystem::Polar, {theta, theta}};
}

GridShape isotropicShape(std::size_t thetas, std::size_t phis)
{
    const auto theta = merl::evenNodes(thetas - 1, pi / 2.0);
    return {AngleSystem::Isotropic, {theta, theta, merl::evenNodes(phis - 1, pi)}};
}

GridShape halfDifferenceShape(std::size_t thetaH, std::size_t thetaD, std::size_t phiD)
{
    return {AngleSystem::HalfDifference,
            {merl::thetaHNodes(thetaH - 1), merl::evenNodes(thetaD - 1, pi / 2.0), merl::evenNodes(phiD - 1, pi)}};
}

BrdfFunction functionOf(const Measurement& measurement)
{
    return [&measurement](std::span<const DirectionPair> pairs) {
        std::vector<std::optional<Mat3d>> values;
        values.reserve(pairs.size());
        for (const DirectionPair& pair : pairs)
            values.push_back(brdfAt(measurement, pair.L, pair.V));
        return values;
    };
}

Table sampled(const GridShape& shape, std::size_t channels, const BrdfFunction& f)
{
    Table table;
    table.system = shape.system;
    table.axes = shape.axes;
    table.channels = channels;
    table.values.reserve(shape.samples() * channels);
    const double lowest = -std::sin(std::min(largestStep(shape.axes[0]) + largestStep(shape.axes[1]), pi / 2.0)) - 1e-9;
    std::vector<std::optional<DirectionPair>> asked;
    for (std::size_t begin = 0; begin < shape.samples(); begin += chunk) {
        asked.clear();
        for (std::size_t sample = begin; sample < std::min(begin + chunk, shape.samples()); ++sample)
            asked.push_back(pairAt(shape, sample, lowest));
        for (const auto& value : valuesAt(asked, f, shape.system == AngleSystem::HalfDifference))
            appendChannels(table.values, value.value_or(Mat3d{{Vec3d(hole), Vec3d(hole), Vec3d(hole)}}), channels);
    }
    return table;
}

ResamplingError resamplingError(const BrdfFunction& f, const Table& table)
{
    const std::vector<DirectionPair> pairs = probes();
    const auto truth = f(pairs);
    ResamplingError error;
    double squares = 0.0;
    double ownSquares = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!truth[i])
            continue;
        const auto found = brdfAt(table, pairs[i].L, pairs[i].V);
        if (!found) {
            ++error.lost;
            continue;
        }
        const double own = pairs[i].L.z * meanOf(*truth[i]);
        const double difference = std::fabs(pairs[i].L.z * meanOf(*found) - own);
        squares += difference * difference;
        ownSquares += own * own;
        largest = std::max(largest, std::fabs(own));
        ++error.compared;
        if (difference > error.worst) {
            error.worst = difference;
            error.at = pairs[i];
        }
    }
    error.rms = ownSquares > 0.0 ? std::sqrt(squares / ownSquares) : 0.0;
    error.worst = largest > 0.0 ? error.worst / largest : 0.0;
    return error;
}

std::string sentenceOf(const ResamplingError& error)
{
    std::string text = general(100.0 * error.rms, 3) + " % rms, " + general(100.0 * error.worst, 3) +
                       " % of the peak at worst, on " + std::to_string(error.compared) + " pairs of directions";
    if (error.lost > 0)
        text += "; " + std::to_string(error.lost) + " more fell into holes";
    return text;
}

Table gridOf(const Measurement& measurement)
{
    const Table* const own = std::get_if<Table>(&measurement);
    if (own && own->system != AngleSystem::Specular)
        return *own;
    const BrdfFunction f = functionOf(measurement);
    Table best;
    ResamplingError least;
    for (const GridShape& shape : {halfDifferenceShape(91, 46, 37), isotropicShape(46, 46)}) {
        Table table = sampled(shape, channelsOf(measurement), f);
        const ResamplingError error = resamplingError(f, table);
        if (best.values.empty() || error.rms < least.rms) {
            best = std::move(table);
            least = error;
        }
    }
    best.provenance = provenanceOf(measurement);
    best.provenance.warnings.push_back("sampled on a grid for the renderers (" + std::string(nameOf(best.system)) +
                                       ", " + std::to_string(best.samples()) + " samples): " + sentenceOf(least));
    return best;
}

} // namespace reflectance
