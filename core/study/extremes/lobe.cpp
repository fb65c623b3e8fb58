// H01 to H04, H07 and H18: the lobe (R.V)^n at the ends of its range.
#include "core/base/text.h"
#include "core/study/extremes/directions.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

Question phong(double n, const Vec3d& V, double ks = 1.0)
{
    Question question{"phong", {{"ks", {ks}}, {"n", {n}}}};
    question.V = V;
    return question;
}

Outcome exactly(const Vec3d& got, const Vec3d& expected)
{
    return {got == expected, textOf(got)};
}

Outcome zeroExponent(Bench& bench)
{
    return exactly(bench.ask(phong(0.0, {std::sqrt(0.51), 0, 0.7}, 0.75)), Vec3d(0.75));
}

Outcome zeroToTheZero(Bench& bench)
{
    const Vec3d rim = bench.ask(phong(0.0, {1, 0, 0}));
    const Vec3d below = bench.ask(phong(0.0, {std::sqrt(0.91), 0, -0.3}));
    return {rim == Vec3d() && below == Vec3d(), textOf(rim) + ", " + textOf(below)};
}

Outcome negativeBase(Bench& bench)
{
    return exactly(bench.ask(phong(10.0, {1, 0, -1e-8})), Vec3d());
}

Question slantedPeak()
{
    Question slanted = phong(1e7, {3, 0, 4}, 0.75);
    slanted.L = {-3, 0, 4};
    return slanted;
}

Outcome overshootAtThePeak(Bench& bench)
{
    const Question slanted = slantedPeak();
    Question head = phong(1e7, {2, 3, 6}, 0.75);
    head.N = head.L = {2, 3, 6};
    const Vec3d a = bench.ask(slanted);
    const Vec3d b = bench.ask(head);
    // One unit leaves no room for R and V to round apart: in these directions they must come out the same.
    const double allowed = bench.unit();
    const bool holds = largestOf(a - Vec3d(0.75)) <= allowed && largestOf(b - Vec3d(0.75)) <= allowed;
    return {holds, textOf(a) + ", " + textOf(b)};
}

Outcome overshootAnywhere(Bench& bench)
{
    constexpr std::size_t count = 20000;
    std::vector<Question> questions;
    for (std::size_t i = 0; i < count; ++i) {
        Question question = phong(1e7, {});
        question.N = spread(i, count);
        question.L = tilted(question.N, 1.5 * static_cast<double>(i % 977) / 977.0, static_cast<double>(i));
        question.V = 2.0 * dot(question.N, question.L) * question.N - question.L;
        questions.push_back(question);
    }
    double largest = 0.0;
    std::size_t above = 0;
    for (const Vec3d& value : bench.ask(questions)) {
        largest = std::max(largest, value.x);
        above += value.x <= 1.0 ? 0 : 1;
    }
    return {above == 0, std::to_string(above) + " above 1, the largest " + general(largest, 9)};
}

/// Every parameter of every model refuses what is no number and what lies beyond its range, and keeps its value.
Outcome outOfRange(Bench& bench)
{
    int refused = 0;
    int taken = 0;
    for (const Model& model : bench.models())
        for (const Parameter& parameter : model.text.parameters) {
            std::vector<std::string> wrong{"nan", "inf", "-inf"};
            if (std::isfinite(parameter.legalMin))
                wrong.push_back(shortest(parameter.legalMin - 1.0));
            if (std::isfinite(parameter.legalMax))
                wrong.emplace_back("1e30");
            for (const std::string& value : wrong) {
                ParameterValues values{{parameter.name, parameter.initial}};
                const auto set = setParameter(model.text, parameter.name + "=" + value, values);
                const bool kept = !set && values.at(parameter.name) == parameter.initial &&
                                  set.error().message.find(parameter.name) != std::string::npos;
                ++(kept ? refused : taken);
            }
        }
    return {refused > 0 && taken == 0,
            std::to_string(refused) + " refused by name, " + std::to_string(taken) + " taken"};
}

Question atTheHorizon(const char* model, double n)
{
    Question question{model, {{"ks", {1.0}}, {"n", {n}}}};
    question.L = {1, 0, 0};
    question.V = {-1, 0, 0};
    return question;
}

Outcome gateAtTheHorizon(Bench& bench)
{
    Vec3d sum;
    for (const double n : {0.0, 1.0, 40.0, 1e7})
        for (const char* model : {"phong", "hybrid"})
            sum += bench.ask(atTheHorizon(model, n));
    return exactly(sum, Vec3d());
}

} // namespace

Hazards lobeHazards() // NOLINT(readability-function-size): a list
{
    return {
        {"H01",
         "n = 0",
         "Phong, ks = 0.75, R.V = 0.7, n = 0",
         "0.75 exactly",
         inEveryPrecision,
         {"phong"},
         zeroExponent,
         seen(phong(0.0, {std::sqrt(0.51), 0, 0.7}, 0.75),
              "0.75 wherever R.V > 0: a lobe without slope, up to its horizon.")},
        {"H02",
         "0 to the power 0",
         "Phong, n = 0, R.V = 0 and -0.3",
         "0, 0: the lobe ends at its horizon",
         inEveryPrecision,
         {"phong"},
         zeroToTheZero,
         seen(phong(0.0, {1, 0, 0}), "The lobe ends where R.V = 0: half of the sphere is 1, the other half 0.")},
        {"H03",
         "a negative base",
         "Phong, n = 10, R.V = -1e-8",
         "0, not NaN",
         inEveryPrecision,
         {"phong"},
         negativeBase,
         seen(phong(10.0, {1, 0, -1e-8}), "Dark beyond the lobe's horizon, and no pixel that is no number.")},
        {"H04",
         "the peak overshoots",
         "Phong, ks = 0.75, n = 1e7, L = (-3,0,4), V = (3,0,4); N = L = V = (2,3,6)",
         "0.75, 0.75 within a unit",
         inEveryPrecision,
         {"phong"},
         overshootAtThePeak,
         seen(slantedPeak(), "The middle is the peak: 0.75, not 0.75 (1 + 7e-7)^n, which is a thousand.")},
        {"H04",
         "the lobe exceeds 1",
         "Phong, n = 1e7, V = R for 20000 directions",
         "0 above 1",
         inEveryPrecision,
         {"phong"},
         overshootAnywhere,
         seen(slantedPeak(), "The middle is the peak. No pixel is brighter than its light.")},
        {"H07",
         "parameters out of range",
         "NaN, infinities, below and beyond the range, every parameter of every model",
         "refused by name, the last value kept",
         {},
         {},
         outOfRange,
         unseen("These values are refused, so no picture has them.")},
        {"H18",
         "the gate at the horizon",
         "Phong and hybrid, N.L = 0, R.V = 1, any n",
         "0",
         inEveryPrecision,
         {"phong", "hybrid"},
         gateAtTheHorizon,
         seen(
             atTheHorizon("hybrid", 40.0),
             "The middle is lit from its horizon and looked at along R: 0. Beyond it, the highlight of the lit side.")},
    };
}

} // namespace reflectance
