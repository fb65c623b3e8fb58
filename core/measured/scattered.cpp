#include "core/measured/scattered.h"

#include "core/base/check.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t neighbours = 12; ///< three times what a plane needs
constexpr double rim = 1e-9;

double squaredDistance(const Angles& a, const Angles& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

struct Neighbour {
    double squaredDistance;
    std::size_t sample;

    friend bool operator<(const Neighbour& a, const Neighbour& b) { return a.squaredDistance < b.squaredDistance; }
};

/// The nearest samples found so far, the farthest of them in front.
class Nearest {
public:
    Nearest() { found_.reserve(neighbours + 1); }

    void offer(double squaredDistance, std::size_t sample)
    {
        if (squaredDistance >= limit())
            return;
        found_.push_back({squaredDistance, sample});
        std::push_heap(found_.begin(), found_.end());
        if (found_.size() > neighbours) {
            std::pop_heap(found_.begin(), found_.end());
            found_.pop_back();
        }
    }

    /// Farther samples are of no interest.
    [[nodiscard]] double limit() const
    {
        return found_.size() < neighbours ? std::numeric_limits<double>::infinity() : found_.front().squaredDistance;
    }

    [[nodiscard]] std::vector<Neighbour> sorted() &&
    {
        std::sort_heap(found_.begin(), found_.end());
        return std::move(found_);
    }

private:
    std::vector<Neighbour> found_;
};

/// The nearest samples but `without`, nearest first. The samples ascend in their first number: the search goes from its
/// place to both sides until that number alone is too far away.
std::vector<Neighbour> nearest(const std::vector<Angles>& points, const Angles& at, std::size_t without)
{
    Nearest found;
    const auto offer = [&](std::size_t i) {
        const double along = points[i][0] - at[0];
        if (along * along >= found.limit())
            return false;
        if (i != without)
            found.offer(squaredDistance(points[i], at), i);
        return true;
    };
    const auto middle = std::lower_bound(points.begin(), points.end(), at,
                                         [](const Angles& a, const Angles& b) { return a[0] < b[0]; });
    std::size_t above = static_cast<std::size_t>(middle - points.begin());
    std::size_t below = above;
    for (bool up = true, down = true; up || down;) {
        up = up && above < points.size() && offer(above++);
        down = down && below > 0 && offer(--below);
    }
    return std::move(found).sorted();
}

/// A symmetric 4x4 system, solved by Cholesky's method; false where it is singular.
bool solved(double (&matrix)[4][4], double (&right)[4])
{
    for (int j = 0; j < 4; ++j) {
        for (int i = j; i < 4; ++i) {
            double sum = matrix[i][j];
            for (int k = 0; k < j; ++k)
                sum -= matrix[i][k] * matrix[j][k];
            if (i == j && !(sum > 0.0))
                return false;
            matrix[i][j] = i == j ? std::sqrt(sum) : sum / matrix[j][j];
        }
    }
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < i; ++k)
            right[i] -= matrix[i][k] * right[k];
        right[i] /= matrix[i][i];
    }
    for (int i = 3; i >= 0; --i) {
        for (int k = i + 1; k < 4; ++k)
            right[i] -= matrix[k][i] * right[k];
        right[i] /= matrix[i][i];
    }
    return true;
}

/// How much each neighbour counts: inverse squared distance, fading to 0 at the farthest, so that neighbours come and go
/// without a jump.
std::vector<double> distanceWeights(const std::vector<Neighbour>& found)
{
    const double farthest = found.back().squaredDistance * (1.0 + 1e-6) + 1e-18;
    std::vector<double> weights;
    for (const Neighbour& neighbour : found) {
        const double fade = 1.0 - std::sqrt(neighbour.squaredDistance / farthest);
        weights.push_back(fade * fade / (neighbour.squaredDistance + 1e-12));
    }
    return weights;
}

/// What the samples' values are multiplied with: the value at `at` of the weighted least-squares plane. The pull towards a
/// flat plane is as strong as 1 % of the neighbours' spread: it decides only where they lie in a line.
std::vector<double> planeWeights(const std::vector<Angles>& points, const std::vector<Neighbour>& found,
                                 const Angles& at)
{
    std::vector<double> weights = distanceWeights(found);
    double matrix[4][4] = {};
    for (std::size_t n = 0; n < found.size(); ++n) {
        const Angles& p = points[found[n].sample];
        const double terms[4] = {1.0, p[0] - at[0], p[1] - at[1], p[2] - at[2]};
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                matrix[i][j] += weights[n] * terms[i] * terms[j];
    }
    const double pull = 0.01 * (matrix[1][1] + matrix[2][2] + matrix[3][3]) + 1e-300;
    for (int i = 1; i < 4; ++i)
        matrix[i][i] += pull;
    double right[4] = {1.0, 0.0, 0.0, 0.0};
    if (!solved(matrix, right))
        return weights;
    std::vector<double> result;
    for (std::size_t n = 0; n < found.size(); ++n) {
        const Angles& p = points[found[n].sample];
        result.push_back(weights[n] * (right[0] + right[1] * (p[0] - at[0]) + right[2] * (p[1] - at[1]) +
                                       right[3] * (p[2] - at[2])));
    }
    return result;
}

std::optional<Channels> valueAt(const ScatteredBrdf& brdf, const Angles& at, std::size_t without)
{
    const std::vector<Neighbour> found = nearest(brdf.points, at, without);
    if (found.empty() || found.front().squaredDistance > brdf.reach * brdf.reach)
        return std::nullopt;
    const std::vector<double> weights = planeWeights(brdf.points, found, at);
    double total = 0.0;
    for (const double weight : weights)
        total += weight;
    Channels result{};
    for (std::size_t c = 0; c < brdf.channels; ++c) {
        double low = brdf.values[found.front().sample * brdf.channels + c];
        double high = low;
        for (std::size_t n = 0; n < found.size(); ++n) {
            const double value = brdf.values[found[n].sample * brdf.channels + c];
            result[c] += weights[n] / total * value;
            low = std::min(low, value);
            high = std::max(high, value);
        }
        result[c] = std::clamp(result[c], low, high);
    }
    return result;
}

/// Twice the distance within which all but one in twenty samples have their nearest neighbour. Of very many samples, a
/// thousand are asked.
double reachOf(const std::vector<Angles>& points)
{
    constexpr std::size_t asked = 1000;
    if (points.size() < 2)
        return 0.0;
    std::vector<double> distances;
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / asked) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < points.size(); ++k)
            if (k != i)
                least = std::min(least, squaredDistance(points[i], points[k]));
        distances.push_back(std::sqrt(least));
    }
    const auto place = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 19 / 20);
    std::nth_element(distances.begin(), place, distances.end());
    return 2.0 * *place;
}

/// Sum of squared errors when every sample (of very many, some hundred) is told from the others; their own squares where
/// the others do not reach.
double leftOutError(const ScatteredBrdf& brdf)
{
    constexpr std::size_t asked = 400;
    double sum = 0.0;
    for (std::size_t i = 0; i < brdf.points.size(); i += 1 + brdf.points.size() / asked) {
        const auto told = leftOut(brdf, i);
        for (std::size_t c = 0; c < brdf.channels; ++c) {
            const double error = brdf.values[i * brdf.channels + c] - (told ? (*told)[c] : 0.0);
            sum += error * error;
        }
    }
    return sum;
}

/// Drops samples with a hole, counts the rest, and sorts them by the first number of their points.
ScatteredBrdf keptSamples(const std::vector<Vec3d>& L, const std::vector<Vec3d>& V, const std::vector<double>& values,
                          std::size_t channels, const ScatteredMetric& metric)
{
    ScatteredBrdf brdf;
    brdf.metric = metric;
    brdf.channels = channels;
    brdf.provenance.samples = L.size();
    std::vector<Angles> points;
    for (std::size_t i = 0; i < L.size(); ++i)
        points.push_back(scatteredPoint(metric, L[i], V[i]));
    std::vector<std::size_t> order(L.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return points[a][0] < points[b][0]; });
    for (const std::size_t i : order) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i * channels);
        const auto end = begin + static_cast<std::ptrdiff_t>(channels);
        if (std::any_of(begin, end, [](double v) { return std::isnan(v); })) {
            ++brdf.provenance.holes;
            continue;
        }
        brdf.provenance.negatives += std::any_of(begin, end, [](double v) { return v < 0.0; }) ? 1 : 0;
        brdf.directions.push_back({L[i], V[i]});
        brdf.points.push_back(points[i]);
        brdf.values.insert(brdf.values.end(), begin, end);
        const double lower = std::min(L[i].z, V[i].z);
        brdf.largestTheta = std::max(brdf.largestTheta, std::acos(std::clamp(lower, 0.0, 1.0)));
    }
    brdf.reach = reachOf(brdf.points);
    return brdf;
}

} // namespace

Angles scatteredPoint(const ScatteredMetric& metric, const Vec3d& L, const Vec3d& V)
{
    const Angles half = anglesOf(AngleSystem::HalfDifference, L, V);
    return {std::pow(half[0] / (pi / 2.0), metric.power), metric.difference * half[1] / (pi / 2.0),
            metric.heights * std::fabs(L.z - V.z)};
}

ScatteredBrdf scatteredBrdf(const std::vector<Vec3d>& L, const std::vector<Vec3d>& V, const std::vector<double>& values,
                            std::size_t channels)
{
    CHECK_EQ(L.size(), V.size());
    CHECK_EQ(values.size(), L.size() * channels);
    ScatteredBrdf glossy = keptSamples(L, V, values, channels, glossyMetric);
    ScatteredBrdf matte = keptSamples(L, V, values, channels, matteMetric);
    return leftOutError(glossy) < leftOutError(matte) ? glossy : matte;
}

std::optional<Mat3d> brdfAt(const ScatteredBrdf& brdf, const Vec3d& L, const Vec3d& V)
{
    const double lowest = std::cos(brdf.largestTheta) - rim;
    if (!(L.z > 0.0) || !(V.z > 0.0) || L.z < lowest || V.z < lowest)
        return std::nullopt;
    const auto values = valueAt(brdf, scatteredPoint(brdf.metric, L, V), brdf.points.size());
    return values ? std::optional(matrixOf(*values, brdf.channels)) : std::nullopt;
}

std::optional<Channels> leftOut(const ScatteredBrdf& brdf, std::size_t sample)
{
    return valueAt(brdf, brdf.points[sample], sample);
}

} // namespace reflectance
