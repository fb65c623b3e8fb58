// The edge of a highlight, for every model that has a number for its width: solved for, and found again in the picture.
#include "core/study/grab/width.h"

#include "core/scene/only_term.h"
#include "tests/study/grab/views.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

constexpr int wide = 320, high = 240;
constexpr double lightAngle = 0.6;

struct Glossy {
    const char* model;
    const char* number; ///< that says how wide its highlight is
};

constexpr Glossy glossy[] = {{"phong", "n"},
                             {"hybrid", "n"},
                             {"phong_normalized", "n"},
                             {"blinn_phong", "n"},
                             {"blinn_phong_normalized", "n"},
                             {"cook_torrance", "m"},
                             {"ward", "alpha"},
                             {"ward_duer", "alpha"},
                             {"ggx", "alpha"}};

/// A sphere seen from afar along z; its highlight lies where the normal is half way to the light, right of the middle.
Scene ballOf(const char* model)
{
    std::mt19937_64 random(1);
    Scene scene = glossyView("sphere", LightKind::Directional, random);
    scene.camera = {{0.0, 0.0, 100.0}, {}, {0.0, 1.0, 0.0}, 1.5};
    scene.surface = Surface();
    scene.surface.model = model;
    scene.lights[0].direction = {std::sin(lightAngle), 0.0, std::cos(lightAngle)};
    return scene;
}

double spotColumn(const Scene& scene)
{
    const double radius = projected(scene.camera, {1.0, 0.0, 0.0}, wide, high).x - wide / 2.0;
    return wide / 2.0 + radius * std::sin(lightAngle / 2.0);
}

ProbedPoint pointOn(const Scene& scene, double x)
{
    const auto point = pointAt(*scene.mesh, scene.camera, x, high / 2.0, wide, high);
    EXPECT_TRUE(point);
    return point.value_or(ProbedPoint());
}

/// Where the highlight alone falls to half of what it is at its spot, in the picture in double, between two pixels' middles.
double edgeInPicture(const Scene& scene, bool toTheRight)
{
    const auto terms = termsAlone(scene);
    const bool has = std::find(terms.begin(), terms.end(), "specular") != terms.end();
    const Scene alone = has ? *onlyTerm(scene, "specular") : scene;
    const Image image = renderOnCpu(alone, {wide, high, 1}, Precision::Double);
    const auto at = [&](int x) {
        // The row of pixels next to the middle: within half a pixel of the plane through spot and light.
        return static_cast<double>(image.at(x, high / 2)[0]);
    };
    const int spot = static_cast<int>(spotColumn(scene)), step = toTheRight ? 1 : -1;
    for (int x = spot; x > 0 && x < wide - 1; x += step) {
        const double here = at(x) / at(spot), next = at(x + step) / at(spot);
        if (next < edgeHeight)
            return x + 0.5 + step * (here - edgeHeight) / (here - next);
    }
    return -1.0;
}

TEST(SpotWidth, IsTheNumberThatShapesTheHighlight)
{
    for (const Glossy& one : glossy) {
        const Scene scene = ballOf(one.model);
        const auto width = spotWidthOf(scene);
        ASSERT_TRUE(width) << one.model;
        EXPECT_EQ(width->parameter->name, one.number) << one.model;
        EXPECT_EQ(width->widens, std::string(one.number) != "n") << one.model;
    }
    for (const char* model : {"lambert", "oren_nayar", "eon", "mirror", "koenderink"})
        EXPECT_FALSE(spotWidthOf(ballOf(model))) << model;
}

TEST(SpotWidth, PutsTheEdgeUnderTheCursor)
{
    for (const Glossy& one : glossy)
        for (const double offset : {-11.0, 9.0, 15.0}) {
            Scene scene = ballOf(one.model);
            const double cursor = spotColumn(scene) + offset;
            const auto width = spotWidthOf(scene);
            ASSERT_TRUE(width);
            const double value = widthWithHeightAt(scene, *width, scene.lights[0], pointOn(scene, cursor), edgeHeight);
            scene.surface.values[one.number] = {value};
            EXPECT_NEAR(*spotHeight(scene, scene.lights[0], pointOn(scene, cursor)), edgeHeight, 1e-9);
            // The promise; the eye turns by 1/100 over the ball, and the spot's pixel is up to half a pixel beside the spot.
            EXPECT_NEAR(edgeInPicture(scene, offset > 0.0), cursor, 1.0) << one.model << " " << offset;
            scene.surface.values[one.number] = {width->widens ? 1.25 * value : value / 1.5}; // planted
            EXPECT_GT(std::fabs(edgeInPicture(scene, offset > 0.0) - cursor), 1.0) << one.model << " " << offset;
        }
}

TEST(SpotWidth, OfPhongIsTheExponent)
{
    Scene scene = ballOf("phong");
    const auto width = spotWidthOf(scene);
    ASSERT_TRUE(width);
    const ProbedPoint point = pointOn(scene, spotColumn(scene) + 10.0);
    const Vec3d L = scene.lights[0].direction, V = normalized(scene.camera.eye - point.P);
    const double mirrored = dot(2.0 * dot(point.N, L) * point.N - L, V);
    for (const double height : {0.1, 0.5, 0.9})
        // A bisection to neighbouring numbers of a function that is good to a few roundings; n ln(R.V) magnifies them.
        EXPECT_NEAR(widthWithHeightAt(scene, *width, scene.lights[0], point, height) * std::log(mirrored),
                    std::log(height), 1e-10);
}

TEST(SpotWidth, StaysInTheSlidersRange)
{
    for (const Glossy& one : glossy) {
        Scene scene = ballOf(one.model);
        const SpotWidth width = *spotWidthOf(scene);
        const double narrow = width.widens ? width.parameter->sliderMin : width.parameter->sliderMax;
        const double broad = width.widens ? width.parameter->sliderMax : width.parameter->sliderMin;
        const auto solved = [&](double x) {
            return widthWithHeightAt(scene, width, scene.lights[0], pointOn(scene, x), edgeHeight);
        };
        ProbedPoint behind = pointOn(scene, spotColumn(scene));
        EXPECT_NEAR(solved(spotColumn(scene)) / narrow, 1.0, 0.2) << "at the peak, but for the mesh's flat triangles";
        behind.N = -scene.lights[0].direction;
        EXPECT_EQ(widthWithHeightAt(scene, width, scene.lights[0], behind, edgeHeight), broad) << one.model;
    }
    Scene typed = ballOf("phong");
    typed.surface.values["n"] = {1e6};
    ProbedPoint peak = pointOn(typed, spotColumn(typed));
    peak.N = normalized(typed.lights[0].direction + normalized(typed.camera.eye - peak.P));
    EXPECT_EQ(widthWithHeightAt(typed, *spotWidthOf(typed), typed.lights[0], peak, edgeHeight), 1e6)
        << "beyond the slider, where it was typed";
}

} // namespace
} // namespace reflectance
