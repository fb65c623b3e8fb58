#include "tests/models/oracle.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <map>

namespace reflectance::test {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Three = std::array<Real, 3>;

/// All inputs of a formula in one list, so that each can be moved in turn: N, L, V (raw), I, radius, parameters.
using Inputs = std::vector<Real>;
constexpr std::size_t atN = 0, atL = 3, atV = 6, atI = 9, atRadius = 12, atParameters = 13;

Three three(const Inputs& inputs, std::size_t at)
{
    return {inputs[at], inputs[at + 1], inputs[at + 2]};
}

Real dot(const Three& a, const Three& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The angle between two vectors of any length; exactly pi/2 only where the dot product is 0.
Real angle(const Three& a, const Three& b)
{
    const Three c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return atan2(sqrt(dot(c, c)), dot(a, b));
}

const Real& rightAngle()
{
    static const Real value = boost::math::constants::half_pi<Real>();
    return value;
}

/// True where the surface is lit: the angle of N and L is below 90 degrees, the horizon itself excluded.
bool lit(const Inputs& x)
{
    return dot(three(x, atN), three(x, atL)) > 0;
}

/// A turned by 180 degrees about the axis N: the part along N stays, the part across it changes sign.
Three turnedAbout(const Three& N, const Three& A)
{
    const Real along = dot(N, A) / dot(N, N);
    Three result;
    for (std::size_t i = 0; i < 3; ++i) {
        const Real part = along * N[i];
        result[i] = part - (A[i] - part);
    }
    return result;
}

Real cosineOfIncidence(const Inputs& x)
{
    return lit(x) ? Real(cos(angle(three(x, atN), three(x, atL)))) : Real(0);
}

Real angleToMirror(const Inputs& x)
{
    return angle(turnedAbout(three(x, atN), three(x, atL)), three(x, atV));
}

Real highlight(const Inputs& x, const Real& n)
{
    const Real delta = angleToMirror(x);
    if (!lit(x) || delta >= rightAngle())
        return 0;
    return exp(n * log(cos(delta)));
}

Three scaled(const Three& v, const Real& factor)
{
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

Three matrixTimesLight(const Inputs& x, std::size_t at)
{
    const Three I = three(x, atI);
    return {dot(three(x, at), I), dot(three(x, at + 3), I), dot(three(x, at + 6), I)};
}

Three lambert(const Inputs& x)
{
    return scaled(three(x, atI), x[atParameters] * cosineOfIncidence(x));
}

Three lambertColor(const Inputs& x)
{
    return scaled(matrixTimesLight(x, atParameters), cosineOfIncidence(x));
}

Three mirror(const Inputs& x)
{
    const Real radius = x[atRadius] * boost::math::constants::degree<Real>();
    return scaled(three(x, atI), lit(x) && angleToMirror(x) < radius ? x[atParameters] : Real(0));
}

Three phong(const Inputs& x)
{
    return scaled(three(x, atI), x[atParameters] * highlight(x, x[atParameters + 1]));
}

Three hybrid(const Inputs& x)
{
    const Three matte = scaled(matrixTimesLight(x, atParameters), cosineOfIncidence(x));
    const Three gloss = scaled(three(x, atI), x[atParameters + 9] * highlight(x, x[atParameters + 10]));
    return {matte[0] + gloss[0], matte[1] + gloss[1], matte[2] + gloss[2]};
}

struct Formula {
    std::vector<std::string> parameters; ///< in the order in which the formula reads them
    Three (*value)(const Inputs&);
};

const Formula& formulaOf(const std::string& model)
{
    static const std::map<std::string, Formula> formulas = {
        {"lambert", {{"kd"}, lambert}},         {"lambert_color", {{"K"}, lambertColor}},
        {"mirror", {{"reflectance"}, mirror}},  {"phong", {{"ks", "n"}, phong}},
        {"hybrid", {{"K", "ks", "n"}, hybrid}},
    };
    return formulas.at(model);
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
    for (const std::string& name : formulaOf(c.model).parameters)
        for (const double number : c.parameters.at(name))
            inputs.emplace_back(number);
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

} // namespace

OracleAnswer oracle(const OracleCase& c, double eps)
{
    const auto value = formulaOf(c.model).value;
    const Inputs inputs = inputsOf(c);
    const Three truth = value(inputs);
    Three sensitivity{};
    const double move = 16.0 * eps;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        Inputs moved = inputs;
        const Real step = stepOf(inputs, i, move);
        moved[i] = inputs[i] + step;
        const Three above = value(moved);
        moved[i] = inputs[i] - step;
        const Three below = value(moved);
        for (std::size_t k = 0; k < 3; ++k)
            sensitivity[k] += std::max(Real(abs(above[k] - truth[k])), Real(abs(below[k] - truth[k]))) / move;
    }
    const auto rounded = [](const Three& t) { return Vec3d{double(t[0]), double(t[1]), double(t[2])}; };
    const Vec3d high = rounded(truth);
    return {high, rounded({truth[0] - high.x, truth[1] - high.y, truth[2] - high.z}), rounded(sensitivity)};
}

double ratioToBound(const OracleCase& c, const Vec3d& got, bool isDouble)
{
    const double eps = isDouble ? 0x1p-53 : 0x1p-24;
    const OracleAnswer truth = oracle(c, eps);
    const double light = std::max({std::fabs(c.I.x), std::fabs(c.I.y), std::fabs(c.I.z)});
    const auto ks = c.parameters.find("ks");
    const double peak = std::max(1.0, light * (ks != c.parameters.end() ? ks->second[0] : 1.0));
    // Twice, because the lanes cut one percent above the smallest normal number, to be safe in exp.
    double allowance = 2.0 * (isDouble ? 0x1p-1022 : 0x1p-126) * peak;
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

} // namespace reflectance::test
