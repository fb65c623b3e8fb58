// H05, H06, H08 and H09: the highlight as a curve, over the angle and over the exponent.
#include "core/base/text.h"
#include "core/study/extremes/directions.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace reflectance {
namespace {

constexpr double smallestFloat = 0x1p-126; ///< below it floats are denormal, and arithmetic may flush them to 0

Question phong(double n, const Vec3d& V)
{
    Question question{"phong", {{"ks", {1.0}}, {"n", {n}}}};
    question.V = V;
    return question;
}

Vec3d offPeak(double angle)
{
    return {std::sin(angle), 0.0, std::cos(angle)};
}

Outcome farOffThePeak(Bench& bench)
{
    double worst = 0.0;
    std::string found;
    for (const auto& [n, angle] : {std::pair(1e7, 1e-2), {1e6, 1e-3}, {1e7, 1e-4}, {1e7, 1e-3}}) {
        const double got = bench.ask(phong(n, offPeak(angle))).x;
        const double truth = powerOfCosine(angle, n);
        const double error = truth < smallestFloat && !bench.isDouble()
                                 ? (got == 0.0 ? 0.0 : INFINITY)
                                 : std::fabs(got / truth - 1.0) / bench.bound(sensitivityOfPower(angle, n));
        worst = worse(worst, error);
        found += (found.empty() ? "" : ", ") + general(got, 7);
    }
    return {worst <= 1.0, found + "; " + general(worst, 2) + " of the bound"};
}

Outcome denormals(Bench& bench)
{
    constexpr double n = 1e5;
    bool holds = true;
    std::string found;
    for (const double exponent : {36.0, 39.0, 41.0, 50.0, 300.0}) {
        const double angle = angleOfVersine(-std::expm1(-exponent * std::numbers::ln10 / n));
        const double got = bench.ask(phong(n, offPeak(angle))).x;
        const double truth = powerOfCosine(angle, n);
        const double allowed =
            bench.bound(sensitivityOfPower(angle, n)) * truth + (bench.isDouble() ? 0.0 : smallestFloat);
        holds = holds && got >= 0.0 && std::fabs(got - truth) <= allowed;
        found += (found.empty() ? "" : ", ") + general(got, 4);
    }
    return {holds, found};
}

/// Off the peak of n = 1e6, in a plane that no axis favours.
Question steepest(double offset)
{
    Question question = phong(1e6, {});
    question.N = normalized(Vec3d(2, 3, 6));
    question.L = tilted(question.N, 0.7, 1.0);
    question.V = tilted(tilted(question.N, 0.7, 1.0 + std::numbers::pi), offset, 2.0);
    return question;
}

/// 200 steps off it.
Outcome highlightFalls(Bench& bench)
{
    constexpr double n = 1e6;
    const auto offset = [](std::size_t i) { return 5e-3 * static_cast<double>(i) / 200.0; };
    std::vector<Question> questions;
    for (std::size_t i = 0; i <= 200; ++i)
        questions.push_back(steepest(offset(i)));
    const std::vector<Vec3d> values = bench.ask(questions);
    double worst = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double rise = values[i].x - values[i - 1].x;
        const double truth = powerOfCosine(offset(i), n);
        const double allowed = 4.0 * (sensitivityOfPower(offset(i), n) + 1.0) * truth * bench.unit() + smallestFloat;
        if (bench.isDouble() ? !(rise < 0.0) : !(rise <= allowed))
            worst = worse(worst, rise);
    }
    return {worst == 0.0, worst == 0.0 ? "falls at every step" : "rises by " + general(worst, 3)};
}

Outcome exponentSwept(Bench& bench)
{
    // Powers of ten, and beside each the nearest integer, where a fast path for integers would switch.
    std::set<double> exponents;
    for (int k = -24; k <= 56; ++k) {
        const double n = std::pow(10.0, k / 8.0);
        exponents.insert({n, std::round(n)});
    }
    constexpr double angle = 0.1;
    double before = 1.0;
    double worst = 0.0;
    for (const double n : exponents) {
        const double got = bench.ask(phong(n, offPeak(angle))).x;
        const double truth = powerOfCosine(angle, n);
        const double allowed =
            bench.bound(sensitivityOfPower(angle, n)) * truth + (bench.isDouble() ? 0x1p-1022 : smallestFloat);
        const double error = std::max(std::fabs(got - truth), got - before) / allowed;
        worst = worse(worst, error);
        before = got;
    }
    return {worst <= 1.0, "worst error " + general(worst, 2) + " of the bound"};
}

} // namespace

Hazards highlightHazards()
{
    return {
        {"H05",
         "off a sharp peak",
         "Phong, n and angle: 1e7 at 1e-2, 1e6 at 1e-3, 1e7 at 1e-4, 1e7 at 1e-3",
         "7.06545e-218 (float: 0), 0.6065306, 0.9512294, 0.006737941 within the bound",
         inEveryPrecision,
         {"phong"},
         farOffThePeak,
         seen(phong(1e7, offPeak(1e-3)),
              "The middle lies 1e-3 off the peak of n = 1e7: 0.0067, at the foot of the highlight.")},
        {"H06",
         "denormal results",
         "Phong, n = 1e5, cos^n = 1e-36, 1e-39, 1e-41, 1e-50, 1e-300",
         "so in double; else to 1.18e-38",
         inEveryPrecision,
         {"phong"},
         denormals,
         seen(phong(1e5, offPeak(4e-3)), "The highlight of n = 1e5: where it has faded, its values fall below what "
                                         "floats hold, and that takes no longer.")},
        {"H08",
         "a highlight with steps",
         "Phong, n = 1e6, 200 offsets up to 5e-3",
         "falls at every step (float: rises by rounding at most)",
         inEveryPrecision,
         {"phong"},
         highlightFalls,
         seen(steepest(0.0),
              "From the middle the highlight falls evenly: no rings, no steps. Zoom in, and put the lens over it.")},
        {"H09",
         "the exponent swept",
         "Phong, 0.1 off the peak, n = 1e-3 .. 1e7 and the integers beside",
         "no rise with n, no step: each value within the bound",
         inEveryPrecision,
         {"phong"},
         exponentSwept,
         seen(phong(1000.0, offPeak(0.1)),
              "The middle lies 0.1 off the peak. Move n slowly past an integer: nothing jumps.")},
    };
}

} // namespace reflectance
