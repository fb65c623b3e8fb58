// H40 to H43: lights at no distance and at any distance, many of them, and intensities that are no light.
#include "core/base/text.h"
#include "core/scene/scene_file.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

Outcome lightAtThePoint(Bench&)
{
    Light light;
    light.kind = LightKind::Point;
    light.position = {1, 2, 3};
    const Arrival there = arrivalAt(light, {1, 2, 3});
    light.position = {1e-20, 0, 0};
    const Arrival near = arrivalAt(light, {});
    return {there.I == Vec3d() && there.L == Vec3d() && near.I == Vec3d(1.0 / (1e-6 * 1e-6)) &&
                near.L == Vec3d(1, 0, 0),
            textOf(there.I) + ", " + textOf(near.I)};
}

Outcome farLight(Bench&)
{
    const Vec3d towards = normalized(Vec3d(1, 2, 3));
    const Vec3d point{0.3, -0.9, 0.3};
    double worst = 0.0;
    for (const double distance : {1e3, 1e6, 1e9, 1e12, 1e15}) {
        Light lamp;
        lamp.kind = LightKind::Point;
        lamp.position = distance * towards;
        const double apart = length(arrivalAt(lamp, point).L - towards);
        // |point| < 1 gives at most 1/D; the position and the unit vector round.
        worst = worse(worst, apart / (1.0 / distance + 4.0 * 0x1p-52));
    }
    return {worst <= 1.0, "direction differs by " + general(worst, 3) + " of the allowed"};
}

/// 1024 lights of intensity 1, but one of 1e8, in directions whose cosines are known.
Outcome manyLights(Bench& bench)
{
    constexpr int count = 1024;
    Observation row{{0, 0, 1}, {0, 0, 1}, {}};
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double strength = i == 400 ? 1e8 : 1.0;
        row.lights.push_back({{std::sin(1e-3 * i), 0, std::cos(1e-3 * i)}, Vec3d(strength), 0.0});
        sum += strength * std::cos(1e-3 * i);
    }
    const Model& lambert = *bench.find("lambert");
    const double white[] = {1.0};
    const double forwards = bench.ask(lambert, white, {&row, 1}).front().x;
    std::reverse(row.lights.begin(), row.lights.end());
    const double backwards = bench.ask(lambert, white, {&row, 1}).front().x;
    row.lights.insert(row.lights.begin() + 7, {{0, 0, 1}, {0, 0, 0}, 0.0});
    const bool blackIsNothing = bench.ask(lambert, white, {&row, 1}).front().x == backwards;
    // A sum of N terms one after the other: at most N units of the sum of their sizes.
    const double worst = std::max(std::fabs(forwards - sum), std::fabs(forwards - backwards)) / sum;
    const Outcome outcome = within(worst, count * bench.unit(), "relative error");
    return {outcome.holds && blackIsNothing,
            outcome.found + (blackIsNothing ? ", black adds nothing" : ", black adds something")};
}

Outcome noLight(Bench&)
{
    std::string found;
    bool holds = true;
    for (const char* intensity : {"[-1, 1, 1]", "[NaN, 1, 1]", "[1e999, 1, 1]", "[1, 1]"}) {
        const auto scene =
            parseScene(std::string("{\"lights\": [{\"intensity\": ") + intensity + "}]}", "light.json", "");
        holds = holds && !scene;
        found += (found.empty() ? "" : ", ") + std::string(scene ? "taken" : "refused");
    }
    return {holds, found};
}

} // namespace

Hazards lightHazards()
{
    return {
        {"H40",
         "a light at the point",
         "a point light at distance 0 and 1e-20",
         "0, 1e12",
         {},
         {},
         lightAtThePoint,
         unseen("A light at a point is shown by the row on the surface.")},
        {"H41",
         "a light far away",
         "a point light at 1e3 .. 1e15 seen from 1 beside the origin",
         "direction to 1/D, subtracted in double",
         {},
         {},
         farLight,
         unseen("The directions differ by less than any pixel.")},
        {"H42",
         "many lights",
         "1024 lights, one 1e8 times brighter, in both orders, one black between",
         "the sum to 1024 units, black adds nothing",
         inEveryPrecision,
         {"lambert"},
         manyLights,
         seen({"lambert", {{"kd", {1.0}}}, {0, 0, 1}, {std::sin(0.4), 0, std::cos(0.4)}, {0, 0, 1}, Vec3d(1e8)},
              "The brightest of the 1024 lights, alone: 1e8. Lower the exposure; the other 1023 would change the sum "
              "by one part in 1e5.")},
        {"H43",
         "an intensity that is none",
         "scene files with -1, NaN, 1e999 and two numbers",
         "all refused",
         {},
         {},
         noLight,
         unseen("These lights are refused, so no picture has them.")},
    };
}

} // namespace reflectance
