#include "core/study/fit/warnings.h"

#include "core/base/text.h"
#include "core/measured/angles.h"
#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

/// A number that is known only to a factor of 3, or to half of its slider and of itself, is not known.
const double largestLogError = std::log(3.0);
constexpr double largestShare = 0.5;
/// Fewer residuals than this, and a single outlier makes the number.
constexpr double fewestRows = 3.0;
constexpr double largestCorrelation = 0.98;
/// The samples miss a lobe where the model reacts this much more beside the mirror direction than at any of them.
constexpr double missedReaction = 10.0;

double degrees(double angle)
{
    return angle * 180.0 / std::numbers::pi;
}

/// How far residuals spread that the model leaves, at least what an instrument would add.
double noiseOf(const Residuals& residuals, const std::vector<double>& flat, std::size_t unknowns)
{
    const double spread =
        std::sqrt(sumOfSquares(residuals.at(flat)) / static_cast<double>(residuals.count() - unknowns));
    return std::max(spread, residuals.instrumentNoise());
}

/// Pairs of directions at and beside the mirror direction, where a lobe would be seen.
Observations aroundTheMirror()
{
    Observations probes{"", ObservedForm::Grey, {}, {}, {}};
    for (const double incidence : {10.0, 30.0, 50.0})
        for (const double beside : {0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0}) {
            const Vec3d L = directionAt(incidence * std::numbers::pi / 180.0, 0.0);
            const Vec3d V = directionAt(std::fabs(incidence - beside) * std::numbers::pi / 180.0,
                                        incidence < beside ? 0.0 : std::numbers::pi);
            observe(probes, L, V, {});
        }
    return probes;
}

/// The largest reaction of the model's value to a variable, over rows.
double largestReaction(const Model& model, const Observations& observations, const std::vector<Variable>& variables,
                       const std::vector<double>& u, const std::vector<double>& flat, std::size_t j)
{
    const Residuals plain(model, observations, Weighting::Linear, true);
    const std::vector<Variable> one{variables[j]};
    double largest = 0.0;
    for (const double reaction : plain.jacobian(one, &u[j], flat))
        largest = std::max(largest, std::fabs(reaction));
    return largest;
}

bool isMissedLobe(const Model& model, const Observations& observations, const std::vector<Variable>& variables,
                  const std::vector<double>& u, const std::vector<double>& flat, std::size_t j)
{
    const double seen = largestReaction(model, observations, variables, u, flat, j);
    const double possible = largestReaction(model, aroundTheMirror(), variables, u, flat, j);
    return possible > 0.0 && possible > missedReaction * seen;
}

bool isUnknown(const Variable& variable, double u, double error)
{
    if (variable.logarithmic)
        return !(error <= largestLogError);
    return !(error <= largestShare * std::max(variable.usualHigh - variable.usualLow, std::fabs(u)));
}

std::string boundText(const Variable& variable, const FittedNumber& number)
{
    const bool isLow = variable.fromValue(number.value) < 0.5 * (variable.usualLow + variable.usualHigh);
    return number.name + " lies at its " + (isLow ? "lower" : "upper") + " bound, " + general(number.value, 4) +
           ": the data ask for " + (isLow ? "less" : "more") + " than the model allows";
}

} // namespace

std::vector<std::string> warningsAbout(const Residuals& residuals, const Observations& observations, const Model& model,
                                       const std::vector<Variable>& variables, const std::vector<double>& u,
                                       const std::vector<double>& flat, const Spread& spread,
                                       std::vector<FittedNumber>& numbers)
{
    std::vector<std::string> warnings;
    const double noise = noiseOf(residuals, flat, variables.size());
    const std::string nearest = general(degrees(nearestMirror(observations)), 3);
    for (std::size_t j = 0; j < variables.size(); ++j) {
        FittedNumber& number = numbers[j];
        const bool missed = isMissedLobe(model, observations, variables, u, flat, j);
        const std::string where =
            "no sample lies within " + nearest + " degrees of the mirror direction, where it would show";
        if (spread.atBound[j]) {
            warnings.push_back(boundText(variables[j], number));
            continue;
        }
        if (!(spread.reaction[j] > 0.0) || isUnknown(variables[j], u[j], noise * spread.unitError[j])) {
            number.determined = false;
            const std::string why = missed                     ? where
                                    : spread.reaction[j] > 0.0 ? "its standard error is as large as its range"
                                                               : "no sample reacts to it";
            warnings.push_back(number.name + " is not determined: " + why);
        } else if (missed) {
            number.determined = false;
            warnings.push_back(number.name + " is hardly determined: " + where);
        } else if (spread.effectiveRows[j] < fewestRows) {
            warnings.push_back(number.name + " rests on " + general(std::round(spread.effectiveRows[j]), 2) +
                               " of the samples: one outlier would move it");
        }
    }
    for (std::size_t a = 0; a < variables.size(); ++a)
        for (std::size_t b = a + 1; b < variables.size(); ++b)
            if (const double r = spread.correlations[a * variables.size() + b]; std::fabs(r) > largestCorrelation)
                warnings.push_back(numbers[a].name + " and " + numbers[b].name +
                                   " cannot be told apart by these data: their correlation is " + general(r, 4));
    return warnings;
}

} // namespace reflectance
