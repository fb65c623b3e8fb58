#include "tests/models/oracle.h"

#include "tests/models/oracle_math.h"

#include <algorithm>
#include <cmath>

namespace reflectance::test {
namespace {

const Formula& formulaOf(const std::string& model)
{
    static const Formulas all = [] {
        Formulas formulas = smoothFormulas();
        formulas.merge(highlightFormulas());
        formulas.merge(roughFormulas());
        formulas.merge(facetFormulas());
        formulas.merge(scatteringFormulas());
        return formulas;
    }();
    return all.at(model);
}

void append(Inputs& inputs, const Vec3d& v)
{
    inputs.insert(inputs.end(), {Real(v.x), Real(v.y), Real(v.z)});
}

Inputs inputsOf(const OracleCase& c)
{
    Inputs inputs;
    for (const Vec3d& v : {c.N, c.L, c.V, c.I})
        append(inputs, v);
    inputs.emplace_back(c.radius);
    for (const auto& [name, count] : formulaOf(c.model).parameters)
        for (std::size_t i = 0; i < (count == 0 ? c.parameters.at(name).size() : count); ++i) {
            const std::vector<double>& numbers = c.parameters.at(name);
            inputs.emplace_back(numbers[numbers.size() == 1 ? 0 : i]);
        }
    return inputs;
}

/// By how much input i is moved: a share of the vector's length for directions, of itself for everything else.
Real stepOf(const Inputs& inputs, std::size_t i, double share)
{
    if (i >= atI)
        return inputs[i] * share;
    const Three v = three(inputs, i - i % 3);
    return sqrt(dot(v, v)) * share;
}

double brightestOf(const OracleCase& c)
{
    return std::max({std::fabs(c.I.x), std::fabs(c.I.y), std::fabs(c.I.z)});
}

Vec3d largerOf(const Vec3d& a, const Vec3d& b)
{
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

Vec3d rounded(const Three& t)
{
    return {double(t[0]), double(t[1]), double(t[2])};
}

/// The farthest that an input is moved, in unit roundoffs.
constexpr double farthest = 16.0;

/// What input i adds to OracleAnswer::sensitivity when it is moved by `reach` unit roundoffs.
Vec3d sensitivityTo(std::size_t i, const OracleCase& c, const Inputs& inputs, const Three& truth, double eps,
                    double reach = farthest)
{
    const auto value = formulaOf(c.model).value;
    const double move = farthest * eps;
    Inputs moved = inputs;
    const Real step = stepOf(inputs, i, reach * eps);
    moved[i] = inputs[i] + step;
    const Three above = value(moved);
    moved[i] = inputs[i] - step;
    const Three below = value(moved);
    Three added{};
    for (std::size_t k = 0; k < 3; ++k)
        added[k] = std::max(Real(abs(above[k] - truth[k])), Real(abs(below[k] - truth[k]))) / move;
    return rounded(added);
}

OracleAnswer answerFrom(const OracleCase& c, const Inputs& inputs, const Three& truth)
{
    const Vec3d high = rounded(truth);
    const auto height = formulaOf(c.model).height;
    return {high,
            rounded({truth[0] - high.x, truth[1] - high.y, truth[2] - high.z}),
            {},
            height ? double(height(inputs)) : 1.0};
}

} // namespace

OracleAnswer oracle(const OracleCase& c, double eps)
{
    const Inputs inputs = inputsOf(c);
    const Three truth = formulaOf(c.model).value(inputs);
    OracleAnswer answer = answerFrom(c, inputs, truth);
    for (std::size_t i = 0; i < inputs.size(); ++i)
        answer.sensitivity += sensitivityTo(i, c, inputs, truth, eps);
    return answer;
}

bool hasNoHalfVector(const OracleCase& c, double eps)
{
    const bool asksForIt = (**findModel(c.model)).text.code.find("halfway(") != std::string::npos;
    return asksForIt && length(normalized(c.L) + normalized(c.V)) < 64.0 * eps;
}

double ratioToBound(const OracleCase& c, const Vec3d& got, bool isDouble)
{
    return ratioToBound(c, oracle(c, isDouble ? 0x1p-53 : 0x1p-24), got, isDouble);
}

double flushed(const OracleCase& c, const OracleAnswer& truth, bool isDouble)
{
    const double peak = std::max(1.0, brightestOf(c) * truth.height);
    // Twice, because the lanes cut one percent above the smallest normal number, to be safe in exp.
    return 2.0 * (isDouble ? 0x1p-1022 : 0x1p-126) * peak;
}

double ratioToBound(const OracleCase& c, const OracleAnswer& truth, const Vec3d& got, bool isDouble)
{
    const double eps = isDouble ? 0x1p-53 : 0x1p-24;
    if (hasNoHalfVector(c, eps))
        return std::isfinite(got.x + got.y + got.z) ? 0.0 : HUGE_VAL;
    const double light = brightestOf(c);
    double allowance = flushed(c, truth, isDouble);
    if (!isDouble && std::fabs(reflectance::dot(normalized(c.N), normalized(c.L))) < 4.0 * eps)
        allowance += 32.0 * eps * light;
    const auto ratio = [&](double g, double value, double remainder, double sensitivity) {
        const double error = std::fabs((g - value) - remainder);
        return error == 0.0 ? 0.0 : error / (32.0 * eps * (sensitivity + std::fabs(value)) + allowance);
    };
    const double ratios[] = {ratio(got.x, truth.value.x, truth.remainder.x, truth.sensitivity.x),
                             ratio(got.y, truth.value.y, truth.remainder.y, truth.sensitivity.y),
                             ratio(got.z, truth.value.z, truth.remainder.z, truth.sensitivity.z)};
    // max would drop a NaN, which must not pass for a small ratio.
    return std::isnan(ratios[0] + ratios[1] + ratios[2]) ? HUGE_VAL : *std::max_element(ratios, ratios + 3);
}

double worstRatio(double worst, const OracleCase& c, const Vec3d& got, bool isDouble)
{
    const Inputs inputs = inputsOf(c);
    const Three truth = formulaOf(c.model).value(inputs);
    OracleAnswer answer = answerFrom(c, inputs, truth);
    const double eps = isDouble ? 0x1p-53 : 0x1p-24;
    double ratio = ratioToBound(c, answer, got, isDouble);
    std::vector<Vec3d> shares(inputs.size());
    // Nearer than the farthest as well: a light's disc of one roundoff, or the peak of a highlight whose half vector is the
    // rest of two opposite directions, lies between.
    for (const double reach : {farthest, 8.0, 4.0, 2.0, 1.0, 0.5, 0.25})
        for (std::size_t i = 0; i < inputs.size() && !(ratio <= worst); ++i) {
            const Vec3d share = largerOf(shares[i], sensitivityTo(i, c, inputs, truth, eps, reach));
            answer.sensitivity += share - shares[i];
            shares[i] = share;
            ratio = ratioToBound(c, answer, got, isDouble);
        }
    return std::max(worst, ratio);
}

} // namespace reflectance::test
