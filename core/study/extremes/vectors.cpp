// H10 to H12 and H17: vectors without direction, without bounds, and at the terminator.
#include "core/base/text.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

const Observation plainRow{{0, 0, 1}, {1, 0, 1.2}, {{{-1, 0, 1.1}, {1, 1, 1}, 20.0}}};

Vec3d defaultsAt(Bench& bench, const Model& model, const Observation& row)
{
    return bench.ask(model, flatValues(model.text, {}), {&row, 1}).front();
}

Outcome zeroVector(Bench& bench)
{
    std::size_t bright = 0;
    for (const Model& model : bench.models())
        for (Vec3d Observation::*which :
             {&Observation::N, &Observation::V, static_cast<Vec3d Observation::*>(nullptr)}) {
            Observation row = plainRow;
            (which ? row.*which : row.lights[0].L) = {};
            bright += defaultsAt(bench, model, row) == Vec3d() ? 0 : 1;
        }
    return {bright == 0, bright == 0 ? "0 in all models" : std::to_string(bright) + " not black"};
}

Outcome anyLength(Bench& bench)
{
    std::size_t different = 0;
    for (const Model& model : bench.models()) {
        Observation extreme = plainRow;
        // Powers of two scale without rounding, so that nothing may differ at all.
        extreme.N = {0, 0, 5e-324};
        extreme.V = 0x1p-664 * plainRow.V;
        extreme.lights[0].L = 0x1p1000 * plainRow.lights[0].L;
        different += defaultsAt(bench, model, extreme) == defaultsAt(bench, model, plainRow) ? 0 : 1;
    }
    Question lambert{"lambert", {{"kd", {1.0}}}};
    double worst = 0.0;
    for (const double size : {1e200, 1e-200, 1e20, 1e-38, 1e-23}) {
        lambert.N = {0.0, 0.0, size};
        lambert.L = {0.6 * size, 0.0, 0.8 * size};
        worst = worse(worst, largestOf(bench.ask(lambert) - Vec3d(0.8)));
    }
    const Outcome outcome = within(worst, 4.0 * bench.unit(), "unit input to");
    return {outcome.holds && different == 0, std::to_string(different) + " models differ; " + outcome.found};
}

Outcome subnormalVector(Bench& bench)
{
    Question question{"lambert", {{"kd", {1.0}}}};
    question.L = {5e-324, 0, 5e-324};
    const Vec3d got = bench.ask(question);
    const Outcome outcome = within(std::fabs(got.x - std::sqrt(0.5)), 4.0 * bench.unit(), "off by");
    return {outcome.holds, textOf(got) + ", " + outcome.found};
}

Outcome terminator(Bench& bench)
{
    double worst = 0.0;
    Vec3d beyond;
    for (const double sine : {1e-12, 1e-15}) {
        Question question{"lambert", {{"kd", {1.0}}}};
        question.L = {1, 0, sine};
        worst = worse(worst, largestOf(bench.ask(question) - Vec3d(sine)) / sine);
        question.L.z = -sine;
        beyond += bench.ask(question);
    }
    const Outcome outcome = within(worst, 4.0 * bench.unit(), "relative error");
    return {outcome.holds && beyond == Vec3d(), outcome.found + ", beyond " + textOf(beyond)};
}

} // namespace

Hazards vectorHazards()
{
    return {
        {"H10",
         "a vector without direction",
         "N, L or V = (0,0,0), every model",
         "0",
         inEveryPrecision,
         {},
         zeroVector,
         unseen("A picture has no vector without direction: cameras, meshes and lights refuse or repair them.")},
        {"H11",
         "huge and tiny vectors",
         "lengths 5e-324 .. 1e301, every model",
         "as unit vectors, to 4 units",
         inEveryPrecision,
         {"lambert"},
         anyLength,
         seen({"lambert", {{"kd", {1.0}}}, {0, 0, 1}, {0.6e200, 0, 0.8e200}, {0, 0, 1}},
              "The light's direction is 1e200 long: the middle is 0.8, as with a unit vector.")},
        {"H12",
         "a subnormal vector",
         "Lambert, L = (5e-324,0,5e-324)",
         "0.707106781 to 4 units",
         inEveryPrecision,
         {"lambert"},
         subnormalVector,
         seen({"lambert", {{"kd", {1.0}}}, {0, 0, 1}, {5e-324, 0, 5e-324}, {0, 0, 1}},
              "The light's direction is the shortest that there is: the middle is 0.707.")},
        {"H17",
         "the terminator",
         "Lambert, N.L = +-1e-12, +-1e-15",
         "N.L to 4 units above, 0 below",
         inEveryPrecision,
         {"lambert"},
         terminator,
         seen({"lambert", {{"kd", {1.0}}}, {0, 0, 1}, {1, 0, 1e-12}, {0, 0, 1}},
              "The terminator runs through the middle: to its left exactly black. The lens shows the digits of N.L "
              "go.")},
    };
}

} // namespace reflectance
