#include "core/study/fit/residuals.h"

#include "core/math/quantile.h"
#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// The step that balances what rounding and what curvature cost a central difference.
const double relativeStep = std::cbrt(std::numeric_limits<double>::epsilon());

std::vector<double> flattened(const Observations& observations, const std::vector<Vec3d>& values, bool cosine)
{
    std::vector<double> numbers;
    numbers.reserve(observations.numbers());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Vec3d x = cosine ? values[i] : values[i] / observations.cosine[i];
        numbers.push_back(x.x);
        if (observations.channels() == 3)
            numbers.insert(numbers.end(), {x.y, x.z});
    }
    return numbers;
}

double tenthOfMedian(std::vector<double> numbers)
{
    if (numbers.empty())
        return 1.0;
    for (double& number : numbers)
        number = std::fabs(number);
    return std::max(0.1 * medianOf(std::move(numbers)), 1e-12); // of data that are mostly 0
}

} // namespace

double sumOfSquares(const std::vector<double>& numbers)
{
    double sum = 0.0;
    for (const double number : numbers)
        sum += number * number;
    return sum;
}

Residuals::Residuals(const Model& model, const Observations& observations, Weighting weighting, bool cosine)
    : model_(model), observations_(observations), weighting_(weighting), cosine_(cosine),
      seen_(flattened(observations, observations.seen, cosine)), scale_(tenthOfMedian(seen_))
{
}

std::vector<double> Residuals::modelled(const std::vector<double>& flat) const
{
    return flattened(observations_, evaluate(model_, flat, observations_.rows, Precision::Double), cosine_);
}

double Residuals::onScale(double x) const
{
    return weighting_ == Weighting::Linear ? x : std::copysign(std::log1p(std::fabs(x) / scale_), x);
}

double Residuals::instrumentNoise() const
{
    constexpr double share = 1e-3;
    if (weighting_ == Weighting::Logarithmic)
        return share;
    return share * std::sqrt(sumOfSquares(seen_) / static_cast<double>(std::max<std::size_t>(1, count())));
}

double Residuals::held(double residual) const
{
    const double size = std::fabs(residual);
    if (robustScale <= 0.0 || size <= robustScale)
        return residual;
    return std::copysign(std::sqrt(robustScale * (2.0 * size - robustScale)), residual);
}

std::vector<double> Residuals::at(const std::vector<double>& flat) const
{
    std::vector<double> result = modelled(flat);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = held(onScale(result[i]) - onScale(seen_[i]));
    return result;
}

std::vector<double> Residuals::jacobian(const std::vector<Variable>& variables, const double* u,
                                        std::vector<double> flat) const
{
    std::vector<double> point(u, u + variables.size());
    std::vector<double> columns;
    columns.reserve(count() * variables.size());
    for (std::size_t j = 0; j < variables.size(); ++j) {
        const Variable& variable = variables[j];
        const double step = relativeStep * std::max(std::fabs(u[j]), 0.1);
        const double below = std::max(u[j] - step, variable.low);
        const double above = std::min(u[j] + step, variable.high);
        point[j] = below;
        put(variables, point.data(), flat);
        const std::vector<double> low = at(flat);
        point[j] = above;
        put(variables, point.data(), flat);
        const std::vector<double> high = at(flat);
        point[j] = u[j];
        for (std::size_t i = 0; i < low.size(); ++i)
            columns.push_back(above > below ? (high[i] - low[i]) / (above - below) : 0.0);
    }
    return columns;
}

} // namespace reflectance
