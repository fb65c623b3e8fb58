#include "core/study/fit/spread.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// Below this share of the largest eigenvalue, J^T J with columns of length 1 is singular: its eigenvalues are squares, so
/// rounding reaches about 1e-14.
constexpr double smallestEigenvalue = 1e-14;
/// Ceres stops at steps of 1e-10 of a variable; what a bound stopped is exactly there or a step away.
constexpr double boundTolerance = 1e-6;

bool isAtBound(const Variable& variable, double u)
{
    const double reach = boundTolerance * std::max(1.0, std::fabs(variable.usualHigh - variable.usualLow));
    return u <= variable.low + reach || u >= variable.high - reach;
}

/// The inverse of a symmetric matrix with a unit diagonal, singular directions held at the smallest eigenvalue.
Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& normal)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(normal);
    const double least = smallestEigenvalue * solver.eigenvalues().maxCoeff();
    return solver.eigenvectors() * solver.eigenvalues().cwiseMax(least).cwiseInverse().asDiagonal() *
           solver.eigenvectors().transpose();
}

void setErrors(Spread& spread, const Eigen::MatrixXd& jacobian, const std::vector<Eigen::Index>& free)
{
    const auto count = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd scaled(jacobian.rows(), count);
    for (Eigen::Index a = 0; a < count; ++a) {
        const double length = spread.reaction[static_cast<std::size_t>(free[static_cast<std::size_t>(a)])];
        scaled.col(a) =
            jacobian.col(free[static_cast<std::size_t>(a)]) / std::max(length, std::numeric_limits<double>::min());
    }
    const Eigen::MatrixXd inverse = inverseOf(scaled.transpose() * scaled);
    const std::size_t width = spread.reaction.size();
    for (Eigen::Index a = 0; a < count; ++a) {
        const auto j = static_cast<std::size_t>(free[static_cast<std::size_t>(a)]);
        spread.unitError[j] =
            std::sqrt(inverse(a, a)) / std::max(spread.reaction[j], std::numeric_limits<double>::min());
        for (Eigen::Index b = 0; b < count; ++b)
            spread.correlations[j * width + static_cast<std::size_t>(free[static_cast<std::size_t>(b)])] =
                a == b ? 1.0 : inverse(a, b) / std::sqrt(inverse(a, a) * inverse(b, b));
    }
}

} // namespace

Spread spreadAt(const Residuals& residuals, const std::vector<Variable>& variables, const std::vector<double>& u,
                const std::vector<double>& flat)
{
    const std::size_t width = variables.size();
    const std::vector<double> columns = residuals.jacobian(variables, u.data(), flat);
    const Eigen::Map<const Eigen::MatrixXd> jacobian(columns.data(), static_cast<Eigen::Index>(residuals.count()),
                                                     static_cast<Eigen::Index>(width));
    Spread spread;
    spread.unitError.assign(width, 0.0);
    spread.correlations.assign(width * width, 0.0);
    std::vector<Eigen::Index> free;
    for (std::size_t j = 0; j < width; ++j) {
        const auto squares = jacobian.col(static_cast<Eigen::Index>(j)).array().square();
        const double sum = squares.sum();
        spread.reaction.push_back(std::sqrt(sum));
        spread.effectiveRows.push_back(sum > 0.0 ? sum * sum / squares.square().sum() : 0.0);
        spread.atBound.push_back(isAtBound(variables[j], u[j]));
        spread.correlations[j * width + j] = 1.0;
        if (!spread.atBound[j])
            free.push_back(static_cast<Eigen::Index>(j));
    }
    if (!free.empty())
        setErrors(spread, jacobian, free);
    return spread;
}

} // namespace reflectance
