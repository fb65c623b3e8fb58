// The lobe drawn at a point is the factor over directions: known shapes, and values asked again.
#include "core/study/probe/lobe_shape.h"

#include "core/reflectance/evaluate.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

constexpr double radius = 0.5;

/// A point at the origin under one light, 40 degrees from N, seen from the side.
Scene sceneWith(const std::string& model)
{
    Scene scene = defaultScene();
    scene.surface.model = model;
    scene.lights.resize(1);
    scene.lights[0].direction = {std::sin(0.7), 0.0, std::cos(0.7)};
    scene.lights[0].angularRadius = 4.0;
    scene.camera.eye = {0.0, -3.0, 3.0};
    return scene;
}

Probe probeOf(const Scene& scene)
{
    ProbedPoint point;
    point.N = {0.0, 0.0, 1.0};
    point.P = {0.1, 0.2, 0.3};
    return probeAt(scene, point);
}

LobeShape shapeOf(const Scene& scene)
{
    return lobeShape(scene, probeOf(scene), 0, radius);
}

template <class See> void eachPlace(const LobeShape& shape, See see)
{
    for (const auto& wire : shape.wires)
        for (const Vec3d& place : wire)
            see(place - Vec3d(0.1, 0.2, 0.3));
    for (const Vec3d& place : shape.inPlane)
        see(place - Vec3d(0.1, 0.2, 0.3));
}

TEST(LobeShape, OfLambertIsAHalfSphere)
{
    const LobeShape shape = shapeOf(sceneWith("lambert"));
    EXPECT_EQ(shape.wires.size(), 12U + 5U);
    EXPECT_NEAR(shape.largest, 0.8 * std::cos(0.7), 1e-15); // kd is 0.8
    eachPlace(shape, [](const Vec3d& place) {
        EXPECT_NEAR(length(place), radius, 1e-15); // one sum and one product per coordinate
        EXPECT_GE(place.z, -1e-15);
    });
}

TEST(LobeShape, IsTheFactorInThatDirection)
{
    for (const char* model : {"hybrid", "oren_nayar", "ggx", "ward"}) {
        const Scene scene = sceneWith(model);
        const Probe probe = probeOf(scene);
        const LobeShape shape = lobeShape(scene, probe, 0, radius);
        ASSERT_GT(shape.largest, 0.0);
        eachPlace(shape, [&](const Vec3d& place) {
            if (length(place) < 1e-3)
                return; // no direction to ask in
            const std::vector<Observation> rows{{probe.point.N, place, {{probe.lights[0].L, {1, 1, 1}, 4.0}}}};
            const Vec3d value = evaluate(modelOf(scene), valuesOf(scene), rows, Precision::Double)[0];
            // The direction was rounded with P's size, 1e-16 against 1e-3; highlights of n = 40 magnify that by less than 100.
            EXPECT_NEAR(length(place), radius * (value.x + value.y + value.z) / 3.0 / shape.largest, 1e-10) << model;
        });
    }
}

TEST(LobeShape, MeetsTheSharpestHighlightOnItsPeak)
{
    Scene scene = sceneWith("phong");
    scene.surface.values["n"] = {1e7};
    const LobeShape shape = shapeOf(scene);
    EXPECT_NEAR(shape.largest, 0.5, 1e-6); // ks; the angle to R is rounded to 1e-16, its square times n is nothing
    double farthest = 0.0;
    Vec3d peak;
    eachPlace(shape, [&](const Vec3d& place) {
        if (length(place) > farthest) {
            farthest = length(place);
            peak = place / length(place);
        }
    });
    EXPECT_LE(length(peak - Vec3d(-std::sin(0.7), 0.0, std::cos(0.7))), 1e-12);
}

TEST(LobeShape, ShowsAMirrorsDisc)
{
    EXPECT_GT(shapeOf(sceneWith("mirror")).largest, 0.0);
}

TEST(LobeShape, IsNoneBehindTheLight)
{
    Scene scene = sceneWith("lambert");
    scene.lights[0].direction = {0.0, 0.0, -1.0};
    const LobeShape shape = shapeOf(scene);
    EXPECT_EQ(shape.largest, 0.0);
    EXPECT_TRUE(shape.wires.empty() && shape.inPlane.empty());
}

} // namespace
} // namespace reflectance
