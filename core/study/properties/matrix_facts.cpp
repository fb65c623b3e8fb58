#include "core/study/properties/matrix_facts.h"

#include "core/base/check.h"

#include <algorithm>
#include <cmath>

namespace reflectance::properties {
namespace {

/// x^3 + b x + c
struct Cubic {
    double b, c;

    [[nodiscard]] double operator()(double x) const { return (x * x + b) * x + c; }
};

/// The determinant of K - (mean + x) 1, up to sign. Without the mean of the diagonal the cubic has no square term, and
/// equal eigenvalues stay equal.
Cubic characteristic(std::span<const double> K, double mean)
{
    const double x = K[0] - mean;
    const double y = K[4] - mean;
    const double z = K[8] - mean;
    const double minors = x * y - K[1] * K[3] + x * z - K[2] * K[6] + y * z - K[5] * K[7];
    const double determinant =
        x * (y * z - K[5] * K[7]) - K[1] * (K[3] * z - K[5] * K[6]) + K[2] * (K[3] * K[7] - y * K[6]);
    return {minors, -determinant};
}

/// The outermost real root. c tells its side; from 0 outwards on that side the cubic crosses 0 once, within Cauchy's
/// bound, so halving cannot fail.
double outermostRoot(const Cubic& p)
{
    double inside = 0.0;
    double outside = std::copysign(1.0 + std::max(std::fabs(p.b), std::fabs(p.c)), -p.c);
    for (int i = 0; i < 100 && p.c != 0.0; ++i) {
        const double middle = 0.5 * (inside + outside);
        ((p(middle) > 0.0) == (p(outside) > 0.0) ? outside : inside) = middle;
    }
    return inside;
}

} // namespace

MatrixFacts matrixFacts(std::span<const double> K)
{
    CHECK_EQ(K.size(), std::size_t{9});
    MatrixFacts facts;
    for (std::size_t i = 0; i < 9; ++i) {
        facts.rowSums[i / 3] += K[i];
        facts.negativeEntries += K[i] < 0.0;
    }
    const double mean = (K[0] + K[4] + K[8]) / 3.0;
    const Cubic p = characteristic(K, mean);
    const double root = outermostRoot(p);
    // What remains after dividing by (x - root) is x^2 + root x + (b + root^2).
    const std::complex<double> apart = std::sqrt(std::complex<double>(-0.75 * root * root - p.b));
    facts.eigenvalues = {mean + root, mean - 0.5 * root + apart, mean - 0.5 * root - apart};
    std::stable_sort(facts.eigenvalues.begin(), facts.eigenvalues.end(),
                     [](const auto& x, const auto& y) { return std::abs(x) > std::abs(y); });
    facts.spectralRadius = std::abs(facts.eigenvalues[0]);
    facts.passive = facts.negativeEntries == 0 && *std::max_element(facts.rowSums.begin(), facts.rowSums.end()) <= 1.0;
    return facts;
}

} // namespace reflectance::properties
