// H70 to H74: what compilers and graphics drivers do to arithmetic.
#include "core/base/embedded.h"
#include "core/base/text.h"
#include "core/sensor/sensor.h"
#include "core/study/extremes/directions.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// How often the prelude, the lobe and the model texts call GLSL's pow, comments left out.
std::size_t callsOfPow(Bench& bench)
{
    std::vector<std::string> texts{std::string(embeddedText("prelude.glsl")),
                                   std::string(embeddedText("lobe/conditioned.glsl"))};
    for (const Model& model : bench.models())
        texts.push_back(model.text.code);
    std::size_t calls = 0;
    for (const std::string& text : texts)
        for (const std::string_view line : split(text, '\n'))
            calls += line.substr(0, line.find("//")).find("pow(") != std::string_view::npos ? 1 : 0;
    return calls;
}

Outcome specialPowers(Bench& bench)
{
    Vec3d sum;
    for (const double n : {0.0, 1e7})
        for (const Vec3d& V : {Vec3d(0, 0, 1), Vec3d(1, 0, 0), Vec3d(0, 0, -1)}) {
            Question question{"phong", {{"ks", {1.0}}, {"n", {n}}}};
            question.V = V;
            sum += bench.ask(question);
        }
    // 1 at the peak for both n, 0 everywhere else.
    const std::size_t calls = callsOfPow(bench);
    return {sum == Vec3d(2.0) && calls == 0, textOf(sum) + ", " + std::to_string(calls) + " calls of pow"};
}

/// Rows all over the sphere and at its edges, every model at its defaults. Pictures cannot show this: shaders lose NaNs
/// in max and clamp.
Outcome hiddenNaNs(Bench& bench)
{
    constexpr std::size_t count = 2000;
    std::vector<Observation> rows;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d N = spread(i, count);
        const double angle = i % 5 == 0 ? 1e-9 : 1.6 * static_cast<double>(i % 97) / 97.0;
        const Vec3d L = tilted(N, angle, static_cast<double>(i));
        rows.push_back(
            {N, i % 7 == 0 ? 2.0 * dot(N, L) * N - L : spread((i * 37) % count, count), {{L, {1, 1, 1}, 0.0}}});
    }
    std::size_t bad = 0;
    for (const Model& model : bench.models())
        for (const Vec3d& value : bench.ask(model, flatValues(model.text, {}), rows))
            bad += isFinite(value) ? 0 : 1;
    return {bad == 0, std::to_string(bad) + " not finite in " + std::to_string(rows.size() * bench.models().size())};
}

/// A NaN must reach the counters: neither models nor sensor may swallow it on the CPU.
Outcome keptNaN(Bench& bench)
{
    Question question{"lambert", {{"kd", {1.0}}}};
    question.I = Vec3d(NAN);
    const Vec3d got = bench.ask(question);
    Image image(1, 1);
    image.rgb = {static_cast<float>(got.x), static_cast<float>(got.y), static_cast<float>(got.z)};
    const std::size_t counted = develop(image, {}).counts.nonFinite;
    return {std::isnan(got.x) && counted == 1, textOf(got) + ", counted " + std::to_string(counted)};
}

Outcome ieeeArithmetic(Bench&)
{
    volatile double zero = 0.0;
    volatile double least = std::numeric_limits<double>::min();
    volatile float leastFloat = std::numeric_limits<float>::min();
    const bool nan = std::isnan(zero / zero);
    const bool subnormal = least / 4.0 > 0.0 && leastFloat / 4.0F > 0.0F;
    return {nan && subnormal, std::string(nan ? "NaN is NaN" : "NaN is lost") + ", " +
                                  (subnormal ? "subnormals stay" : "subnormals are flushed")};
}

/// a a - (1 + 2^-29) for a = 1 + 2^-30: 0 when the product rounds, 2^-60 when it is contracted.
Outcome contraction(Bench&)
{
    volatile double start = 1.0 + 0x1p-30;
    const double a = start;
    const double left = a * a - (1.0 + 0x1p-29);
    return {left == 0.0, general(left, 3)};
}

/// Well-conditioned rows in scalar float and in this arithmetic: at most 2 units in the last place apart.
Outcome fusedLanes(Bench& bench)
{
    constexpr std::size_t count = 1000;
    std::vector<Question> questions;
    for (std::size_t i = 0; i < count; ++i) {
        Question question{"lambert_color", {{"K", {0.6, 0.05, 0.02, 0.06, 0.3, 0.03, 0.02, 0.05, 0.2}}}};
        question.N = spread(i, count);
        question.L = tilted(question.N, static_cast<double>(i) / static_cast<double>(count), 1.0);
        questions.push_back(question);
    }
    const std::vector<Vec3d> got = bench.ask(questions);
    double worst = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double cosine = std::cos(static_cast<double>(i) / static_cast<double>(count));
        worst = worse(worst, largestOf(got[i] - cosine * Vec3d(0.67, 0.39, 0.27)) / (0.67 * cosine));
    }
    // Inputs round to 1 unit each (tan 1 = 1.6 of them in the cosine), sums and products to 5; fused or not.
    return within(worst, 12.0 * bench.unit(), "off by");
}

Outcome droppedTerm(Bench& bench)
{
    constexpr std::size_t count = 500;
    std::vector<Question> general;
    std::vector<Question> special;
    for (std::size_t i = 0; i < count; ++i) {
        Question question{"hybrid", {{"ks", {0.0}}, {"n", {1e7}}}};
        question.N = spread(i, count);
        question.L = tilted(question.N, 1.7 * static_cast<double>(i) / static_cast<double>(count), 2.0);
        question.V = spread((i * 37) % count, count);
        general.push_back(question);
        question.model = "lambert_color";
        special.push_back(question);
    }
    const std::vector<Vec3d> with = bench.ask(general);
    const std::vector<Vec3d> without = bench.ask(special);
    std::size_t different = 0;
    for (std::size_t i = 0; i < count; ++i)
        different += with[i] == without[i] ? 0 : 1;
    return {different == 0, std::to_string(different) + " of 500 differ"};
}

} // namespace

Hazards arithmeticHazards() // NOLINT(readability-function-size): a list
{
    const std::vector<Precision> onCpu{Precision::Double, Precision::Float, Precision::Simd};
    return {
        {"H70",
         "special values of pow",
         "Phong, n = 0 and 1e7, R.V = 1, 0, -1; the shader texts",
         "1 at the peaks (sum 2), 0 elsewhere, 0 calls of pow",
         inEveryPrecision,
         {"phong"},
         specialPowers,
         seen({"phong", {{"ks", {1.0}}, {"n", {1e7}}}},
              "The peak of n = 1e7: 1 in the middle, 0 elsewhere, and no pixel that is no number.")},
        {"H71",
         "a NaN that a shader hides",
         "2000 rows over the sphere and at its edges, every model",
         "0 not finite",
         inEveryPrecision,
         {},
         hiddenNaNs,
         unseen("A shader hides such pixels, so that a picture cannot show them; the rows are asked one by one.")},
        {"H71",
         "a NaN that is swallowed",
         "Lambert, I = NaN",
         "nan, counted 1",
         onCpu,
         {"lambert"},
         keptNaN,
         unseen("No light that is no number can be set; the row asks the model itself.")},
        {"H72",
         "fast-math",
         "0/0; the smallest normal numbers over 4",
         "NaN is NaN, subnormals stay",
         {},
         {},
         ieeeArithmetic,
         unseen("This asks the compiler's arithmetic for two numbers; no picture depends on it.")},
        {"H73",
         "contracted products",
         "a a - (1 + 2^-29), a = 1 + 2^-30",
         "0 (fused: 8.67e-19)",
         {},
         {},
         contraction,
         unseen("This asks the compiler's arithmetic for one number; no picture depends on it.")},
        {"H73",
         "fused or not",
         "Lambert in colour, 1000 rows with N.L > 0.54",
         "cos (0.67, 0.39, 0.27) to 12 units",
         inEveryPrecision,
         {"lambert_color"},
         fusedLanes,
         unseen("The difference is two units in the last place, which no picture shows. The lens does.")},
        {"H74",
         "a term of zero",
         "hybrid with ks = 0, n = 1e7, against Lambert in colour, 500 rows",
         "0 of 500 differ",
         inEveryPrecision,
         {"hybrid", "lambert_color"},
         droppedTerm,
         seen({"hybrid", {{"ks", {0.0}}, {"n", {1e7}}}, {0, 0, 1}, {0.5, 0.3, 0.8}, {0, 0, 1}},
              "Press M to see the model without the term: not a pixel changes.")},
    };
}

} // namespace reflectance
