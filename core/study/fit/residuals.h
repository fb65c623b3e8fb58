// How far a model is from what was seen: one number per row and channel, weighted as the user asks.
#pragma once

#include "core/study/fit/observations.h"
#include "core/study/fit/variables.h"

#include <string_view>
#include <vector>

namespace reflectance {

/// Linear: every difference counts as it is, so highlights rule. Logarithmic: differences of ln(1 + |x| / s), odd in x, with s
/// a tenth of the median |x| that was seen: dark and bright angles count alike, noise below s does not.
enum class Weighting { Linear, Logarithmic };

[[nodiscard]] constexpr std::string_view nameOf(Weighting weighting)
{
    constexpr std::string_view names[] = {"linear", "log"};
    return names[static_cast<int>(weighting)];
}

[[nodiscard]] double sumOfSquares(const std::vector<double>& numbers);

class Residuals {
public:
    /// x is pi f, or pi f (N.L) with `cosine`: what a light that shines evenly from everywhere would weigh it with.
    Residuals(const Model& model, const Observations& observations, Weighting weighting, bool cosine);

    [[nodiscard]] std::size_t count() const { return seen_.size(); }
    /// x as it was seen, one per row and channel.
    [[nodiscard]] const std::vector<double>& seen() const { return seen_; }
    /// x of the model for a flat list of parameter values.
    [[nodiscard]] std::vector<double> modelled(const std::vector<double>& flat) const;
    /// Model minus seen, on the weighting's scale; outliers beyond `robustScale` (0: none) count with their root (Huber).
    [[nodiscard]] std::vector<double> at(const std::vector<double>& flat) const;
    /// d x / d u or d residual / d u for each variable, column by column, by central differences inside the bounds.
    [[nodiscard]] std::vector<double> jacobian(const std::vector<Variable>& variables, const double* u,
                                               std::vector<double> flat) const;

    /// What an instrument leaves at least, on the weighting's scale: 1/1000 of what it sees. Synthetic data leave less.
    [[nodiscard]] double instrumentNoise() const;

    double robustScale = 0.0;

private:
    [[nodiscard]] double onScale(double x) const;
    [[nodiscard]] double held(double residual) const;

    const Model& model_;
    const Observations& observations_;
    Weighting weighting_;
    bool cosine_;
    std::vector<double> seen_;
    double scale_ = 1.0; ///< s of Weighting::Logarithmic
};

} // namespace reflectance
