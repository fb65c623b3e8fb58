// H20 to H24: the colour matrix K, where entries cancel, results turn negative, and surfaces return more than they get.
#include "core/base/text.h"
#include "core/sensor/sensor.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

Question matte(const std::vector<double>& K, const Vec3d& I)
{
    Question question{"lambert_color", {{"K", K}}};
    question.L = {0.6, 0, 0.8};
    question.I = I;
    return question;
}

Outcome oppositeEntries(Bench& bench)
{
    Vec3d sizes;
    for (const auto& K : {std::vector<double>{1, -1, 0, 0, 1, -1, -1, 0, 1}, {-1, 0, 1, 1, -1, 0, 0, 1, -1}}) {
        const Vec3d got = bench.ask(matte(K, {1, 1, 1}));
        sizes += Vec3d(largestOf(got));
    }
    return {sizes == Vec3d(), textOf(sizes)};
}

/// Negative in the linear picture, 0 after the sensor, and counted there.
Outcome negativeResult(Bench& bench)
{
    const Vec3d got = bench.ask(matte({0.9, -0.08, 0.01, 0.02, 0.7, 0.05, 0.0, -0.06, 0.5}, {0, 1, 0}));
    const double error = largestOf(got - Vec3d(-0.064, 0.56, -0.048)) / 0.56;
    Image image(1, 1);
    image.rgb = {static_cast<float>(got.x), static_cast<float>(got.y), static_cast<float>(got.z)};
    const Developed shown = develop(image, {});
    const bool holds =
        error <= bench.bound(0.0) && shown.rgb[0] == 0 && shown.rgb[2] == 0 && shown.counts.negative == 1;
    return {holds, textOf(got) + "; shown as " + std::to_string(shown.rgb[0]) + ", counted " +
                       std::to_string(shown.counts.negative)};
}

Outcome cancellation(Bench& bench)
{
    // Every entry of K and I is exact in float, so that only the sums and the cosine round.
    const Vec3d got = bench.ask(matte({1e6, -1e6, 0.5, -1e6, 1e6, 0.25, 1.0, -1e6, 1e6}, {1.0, 0.75, 1.25}));
    const Vec3d expected = 0.8 * Vec3d(250000.625, -249999.6875, 500001.0);
    // 4 units of the sum of |K_ij I_j| for products and sums, as much again for the cosine and its product.
    return within(largestOf(got - expected), 8.0 * bench.unit() * 0.8 * 2000001.0, "off by");
}

Outcome permutation(Bench& bench)
{
    const Vec3d got = bench.ask(matte({0, 1, 0, 0, 0, 1, 1, 0, 0}, {0.2, 0.5, 0.9}));
    const Vec3d cheat = bench.ask(matte({0, 0, 0, 0, 0, 0, 0, 0, 0}, {0.2, 0.5, 0.9}));
    const double error = largestOf(got - Vec3d(0.4, 0.72, 0.16));
    return {error <= 4.0 * bench.unit() && cheat == Vec3d(), textOf(got) + "; its diagonal " + textOf(cheat)};
}

Outcome notPassive(Bench& bench)
{
    const Vec3d grey = bench.ask(Question{"lambert", {{"kd", {1.5}}}});
    const Vec3d color = bench.ask(Question{"lambert_color", {{"K", {1, 1, 1, 0, 2, 0, 0, 0, 3}}}});
    // What the models declare about themselves must name the limit.
    const bool labelled = bench.find("lambert")->text.passive.reason.find("kd <= 1") != std::string::npos &&
                          bench.find("lambert_color")->text.passive.reason.find("row sum") != std::string::npos;
    return {grey == Vec3d(1.5) && color == Vec3d(3, 2, 3) && labelled,
            textOf(grey) + ", " + textOf(color) + (labelled ? ", limit declared" : ", limit not declared")};
}

Outcome eonAboveOne(Bench& bench)
{
    ParameterValues values;
    const auto set = setParameter(bench.find("eon")->text, "rho=1.5", values);
    return {!set, set ? "taken" : set.error().message};
}

} // namespace

Hazards matrixHazards()
{
    return {
        {"H20",
         "opposite entries of K",
         "K = [1 -1 0; 0 1 -1; -1 0 1] and its negative turned, I = white",
         "0 exactly",
         inEveryPrecision,
         {"lambert_color"},
         oppositeEntries,
         seen(matte({1, -1, 0, 0, 1, -1, -1, 0, 1}, {1, 1, 1}),
              "White light on entries that cancel: black everywhere, not nearly black.")},
        {"H21",
         "a negative result",
         "K with off-diagonals -0.08, -0.06, I = (0,1,0), N.L = 0.8",
         "-0.064 0.56 -0.048; shown as 0, counted 1",
         inEveryPrecision,
         {"lambert_color"},
         negativeResult,
         seen(matte({0.9, -0.08, 0.01, 0.02, 0.7, 0.05, 0.0, -0.06, 0.5}, {0, 1, 0}),
              "Green light: red and blue are negative. The sensor shows 0 and counts them; the lens marks them.")},
        {"H22",
         "cancellation in K I",
         "K entries +-1e6",
         "within 8 units of the sum of |K_ij I_j|",
         inEveryPrecision,
         {"lambert_color"},
         cancellation,
         seen(matte({1e6, -1e6, 0.5, -1e6, 1e6, 0.25, 1.0, -1e6, 1e6}, {1.0, 0.75, 1.25}),
              "Red is a million minus three quarters of one, green is negative. The lens tells what is left of the "
              "digits; lower the exposure to see colours.")},
        {"H23",
         "a permutation K",
         "K = [0 1 0; 0 0 1; 1 0 0], I = (0.2,0.5,0.9), N.L = 0.8",
         "0.4 0.72 0.16; its diagonal 0",
         inEveryPrecision,
         {"lambert_color"},
         permutation,
         seen(matte({0, 1, 0, 0, 0, 1, 1, 0, 0}, {0.2, 0.5, 0.9}),
              "A blue light, and a surface that passes its primaries round: it looks green. K's diagonal alone would "
              "be black.")},
        {"H24",
         "a surface that is not passive",
         "kd = 1.5; K with row sums 3, 2, 3",
         "1.5, 3 2 3: as it is, and the limit declared",
         inEveryPrecision,
         {"lambert", "lambert_color"},
         notPassive,
         seen(Question{"lambert_color", {{"K", {1, 1, 1, 0, 2, 0, 0, 0, 3}}}},
              "3, 2, 3 at the middle: shown as it is. The lens marks where more leaves than arrives.")},
        {"H24",
         "EON divides by 1 - rho (1 - E)",
         "rho = 1.5",
         "refused",
         {},
         {"eon"},
         eonAboveOne,
         unseen("This albedo is refused, so no picture has it.")},
    };
}

} // namespace reflectance
