#include "core/study/fit/fit.h"

#include "core/base/text.h"
#include "core/math/quantile.h"
#include "core/study/fit/solve.h"
#include "core/study/fit/spread.h"
#include "core/study/fit/warnings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// Huber's threshold in standard deviations, which keeps 95 % of the efficiency where there are no outliers; and what makes
/// a standard deviation of a median of absolute values.
constexpr double huberThreshold = 1.345;
constexpr double deviationFromMedian = 1.4826;

double radicalInverse(int index, int base)
{
    double result = 0.0;
    for (double digit = 1.0 / base; index > 0; index /= base, digit /= base)
        result += digit * (index % base);
    return result;
}

/// Start 0 has the defaults; the others spread the shapes over their sliders by Halton's sequence.
std::vector<double> startNumber(int index, const std::vector<Variable>& variables, const std::vector<double>& initial)
{
    static constexpr int bases[] = {2, 3, 5, 7, 11, 13};
    std::vector<double> u;
    std::size_t shapes = 0;
    for (const Variable& variable : variables) {
        double start = variable.fromValue(initial[variable.slots.front()]);
        if (variable.isShape && index > 0)
            start = variable.usualLow + (variable.usualHigh - variable.usualLow) *
                                            radicalInverse(index, bases[shapes++ % std::size(bases)]);
        u.push_back(std::clamp(start, variable.low, variable.high));
    }
    return u;
}

Error refusal(const Model& model, const std::string& what)
{
    return Error{"model " + model.id() + " cannot be fitted: " + what};
}

Result<void> checked(const Model& model, const Observations& observations, const std::vector<Variable>& variables)
{
    if (model.text.usesLightSize)
        return refusal(model, "it shows the light itself, which no BRDF measures; choose another model");
    if (variables.empty())
        return refusal(model, "it has no parameter left to turn; choose another model, or fix fewer");
    if (observations.numbers() <= variables.size())
        return refusal(model, "it has " + std::to_string(variables.size()) + " unknowns, and " + observations.name +
                                  " gives " + std::to_string(observations.numbers()) + " numbers; measure more");
    for (const Vec3d& seen : observations.seen)
        if (!std::isfinite(seen.x + seen.y + seen.z))
            return Error{"holds a value that is not finite", observations.name};
    return {};
}

struct Best {
    Solution solution;
    int tried = 0, agree = 0;
};

Best bestOf(const Residuals& residuals, const std::vector<Variable>& variables, const std::vector<double>& flat,
            const std::vector<std::vector<double>>& starts, Progress* progress)
{
    Best best;
    best.solution.cost = std::numeric_limits<double>::infinity();
    std::vector<double> costs;
    for (const std::vector<double>& start : starts) {
        if (progress && progress->cancel)
            break;
        Solution solution = solved(residuals, variables, start, flat, progress);
        costs.push_back(solution.cost);
        if (best.tried++ == 0 || solution.cost < best.solution.cost)
            best.solution = std::move(solution);
        if (progress)
            progress->done = static_cast<double>(best.tried) / static_cast<double>(starts.size());
    }
    const double enough = best.solution.cost * (1.0 + 1e-6) + std::numeric_limits<double>::min();
    best.agree =
        static_cast<int>(std::count_if(costs.begin(), costs.end(), [&](double cost) { return cost <= enough; }));
    return best;
}

std::vector<std::vector<double>> startsFor(const std::vector<Variable>& variables, const std::vector<double>& initial,
                                           int wanted)
{
    const bool hasShapes = std::any_of(variables.begin(), variables.end(), [](const Variable& v) { return v.isShape; });
    std::vector<std::vector<double>> starts;
    for (int i = 0; i < (hasShapes ? std::max(1, wanted) : 1); ++i)
        starts.push_back(startNumber(i, variables, initial));
    return starts;
}

double robustScaleOf(std::vector<double> residuals)
{
    for (double& r : residuals)
        r = std::fabs(r);
    return huberThreshold * deviationFromMedian * medianOf(std::move(residuals));
}

void setFigures(FitResult& result, const Residuals& residuals, const std::vector<double>& flat, std::size_t unknowns)
{
    const auto N = static_cast<double>(residuals.count());
    std::vector<double> difference = residuals.modelled(flat);
    for (std::size_t i = 0; i < difference.size(); ++i)
        difference[i] -= residuals.seen()[i];
    const double seen = sumOfSquares(residuals.seen());
    result.residuals = residuals.count();
    result.rms = std::sqrt(sumOfSquares(difference) / N);
    result.relativeRms = seen > 0.0 ? std::sqrt(sumOfSquares(difference) / seen) : 0.0;
    const double rss = sumOfSquares(residuals.at(flat));
    result.weightedRms = std::sqrt(rss / N);
    const double p = static_cast<double>(unknowns) + 1.0;
    const double fit = N * std::log(std::max(rss / N, std::numeric_limits<double>::min()));
    result.aic = fit + 2.0 * p;
    result.bic = fit + p * std::log(N);
}

std::vector<FittedNumber> numbersOf(const std::vector<Variable>& variables, const std::vector<double>& u,
                                    const Spread& spread, double deviation)
{
    std::vector<FittedNumber> numbers;
    for (std::size_t j = 0; j < variables.size(); ++j) {
        const double error = deviation * spread.unitError[j] * variables[j].derivative(u[j]);
        numbers.push_back({variables[j].name, variables[j].toValue(u[j]), error, spread.atBound[j], true});
    }
    return numbers;
}

} // namespace

Result<FitResult> fitModel(const Model& model, const Observations& observations, const FitOptions& options,
                           Progress* progress)
{
    const std::vector<Variable> variables = variablesOf(model.text, observations.form, options.fixed, options.grey);
    if (const auto fits = checked(model, observations, variables); !fits)
        return fits.error();
    std::vector<double> flat = valuesAround(model.text, observations.form, options.fixed, options.grey);
    Residuals residuals(model, observations, options.weighting, options.cosine);
    Best best = bestOf(residuals, variables, flat, startsFor(variables, flat, options.starts), progress);
    if (options.robust && std::isfinite(best.solution.cost)) {
        put(variables, best.solution.u.data(), flat);
        residuals.robustScale = robustScaleOf(residuals.at(flat));
        best.solution = solved(residuals, variables, best.solution.u, flat, progress);
    }
    if (progress && progress->cancel)
        return Error{"stopped"};
    if (!std::isfinite(best.solution.cost))
        return refusal(model, "its values are not finite for " + observations.name);
    const std::vector<double>& u = best.solution.u;
    put(variables, u.data(), flat);
    FitResult result;
    result.startsTried = best.tried;
    result.startsThatAgree = best.agree;
    result.iterations = best.solution.iterations;
    result.values = namedValues(model.text, flat);
    setFigures(result, residuals, flat, variables.size());
    const Spread spread = spreadAt(residuals, variables, u, flat);
    const double N = static_cast<double>(result.residuals);
    const double deviation = result.weightedRms * std::sqrt(N / (N - static_cast<double>(variables.size())));
    result.numbers = numbersOf(variables, u, spread, deviation);
    result.correlations = spread.correlations;
    result.warnings = warningsAbout(residuals, observations, model, variables, u, flat, spread, result.numbers);
    if (!best.solution.converged)
        result.warnings.emplace_back("the fit had not settled when it was ended; more starts may find a better one");
    return result;
}

} // namespace reflectance
