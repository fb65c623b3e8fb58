// What lies under a cursor: spot, edge and terminator of a sphere, where closed forms put them.
#include "tests/study/grab/views.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

constexpr double reach = 3.0;

/// A sphere seen from afar along z, so that a pixel at s radii from the middle has the normal (s, sqrt(1 - s^2)).
struct Ball {
    Scene scene;
    double radius = 0.0; ///< in pixels

    explicit Ball(double lightAngle)
    {
        std::mt19937_64 random(1);
        scene = glossyView("sphere", LightKind::Directional, random);
        scene.camera = {{0.0, 0.0, 100.0}, {}, {0.0, 1.0, 0.0}, 1.5};
        scene.surface.model = "hybrid";
        scene.surface.values["n"] = {40.0};
        scene.lights[0].direction = {std::sin(lightAngle), 0.0, std::cos(lightAngle)};
        radius = projected(scene.camera, {1.0, 0.0, 0.0}, viewWidth, viewHeight).x - viewWidth / 2.0;
    }
    /// The point whose normal is `angle` radians from the eye's direction, towards +x, and `pixels` farther.
    [[nodiscard]] std::optional<Grasp> at(double angle, double pixels = 0.0) const
    {
        const double x = viewWidth / 2.0 + radius * std::sin(angle) + pixels;
        const auto point = pointAt(*scene.mesh, scene.camera, x, viewHeight / 2.0, viewWidth, viewHeight);
        return point ? graspAt(scene, *point, reach) : std::nullopt;
    }
};

TEST(Grasp, TheSpotLiesHalfWayToTheLight)
{
    const Ball ball(0.6);
    ASSERT_TRUE(ball.at(0.3));
    EXPECT_EQ(ball.at(0.3)->grip, Grip::Spot);
    EXPECT_EQ(ball.at(0.3)->light, 0U);
    EXPECT_FALSE(ball.at(-0.6)) << "lit, but neither spot nor line";
}

TEST(Grasp, TheEdgeLiesWhereTheLobeHasHalfItsHeight)
{
    const Ball ball(0.6);
    // R turns twice as fast as N.
    const double half = std::acos(std::pow(0.5, 1.0 / 40.0)) / 2.0;
    for (const double side : {-1.0, 1.0}) {
        const auto grasp = ball.at(0.3 + side * half);
        ASSERT_TRUE(grasp);
        EXPECT_EQ(grasp->grip, Grip::Edge);
        // The eye at a hundred radii turns by up to 1/100; the mesh's normals are interpolated between vertices.
        EXPECT_LT(grasp->pixels, 1.5);
    }
    EXPECT_FALSE(ball.at(0.3 + half, 2.0 * reach + 2.0));
}

TEST(Grasp, TheTerminatorLiesWhereTheLightGoesDown)
{
    const Ball ball(0.9 + std::numbers::pi / 2.0); // goes down 0.9 radians towards +x
    const auto grasp = ball.at(0.9);
    ASSERT_TRUE(grasp);
    EXPECT_EQ(grasp->grip, Grip::Terminator);
    EXPECT_LT(grasp->pixels, 1.5);
    EXPECT_FALSE(ball.at(0.2)) << "in the dark";
}

TEST(Grasp, OfTwoLightsTheBrighterIsTaken)
{
    Ball ball(0.6);
    ball.scene.lights.push_back(ball.scene.lights[0]);
    ball.scene.lights[1].intensity = Vec3d(3.0);
    EXPECT_EQ(ball.at(0.3)->light, 1U);
    ball.scene.lights[1].on = false;
    EXPECT_EQ(ball.at(0.3)->light, 0U);
    ball.scene.lights[0].on = false;
    EXPECT_FALSE(ball.at(0.3)) << "nothing shines";
}

TEST(Grasp, AMatteSurfaceHasItsSpotWhereItFacesTheLight)
{
    Ball ball(0.6);
    ball.scene.surface.model = "oren_nayar";
    EXPECT_EQ(ball.at(0.6)->grip, Grip::Spot);
    EXPECT_FALSE(ball.at(0.0));
}

TEST(SpotKind, IsMirroredForEveryModelWithAHighlight)
{
    Scene scene = defaultScene();
    for (const char* id : {"mirror", "phong", "hybrid", "blinn_phong", "ggx", "cook_torrance", "ward"}) {
        scene.surface.model = id;
        EXPECT_EQ(spotKindOf(scene), SpotKind::Mirrored) << id;
    }
    for (const char* id : {"lambert", "lambert_color", "oren_nayar", "eon"}) {
        scene.surface.model = id;
        EXPECT_EQ(spotKindOf(scene), SpotKind::Facing) << id;
    }
    scene.surface.model = "hybrid";
    scene.surface.values["ks"] = {0.0};
    EXPECT_EQ(spotKindOf(scene), SpotKind::Facing) << "a hybrid without a highlight";
}

TEST(SpotIn, FindsWhatWasPutThere)
{
    std::mt19937_64 random(9);
    for (const LightKind kind : {LightKind::Directional, LightKind::Point})
        for (int view = 0; view < 6; ++view) {
            Scene scene = glossyView("sphere", kind, random); // has one spot
            const auto cursor = anyPoint(scene, random);
            ASSERT_TRUE(cursor);
            const Light moved = *withSpotAt(scene.lights[0], scene.camera.eye, *cursor, SpotKind::Mirrored);
            const auto found = spotIn(scene, moved, viewWidth, viewHeight);
            ASSERT_TRUE(found);
            // The search ends with steps of a quarter of a pixel along the axes.
            EXPECT_LT(std::hypot(found->x - cursor->x, found->y - cursor->y), 1.0);
        }
}

TEST(SpotIn, FindsNothingWhereTheLightIsBehind)
{
    Ball ball(0.6); // a ball has its spot on the rim then, a cube has none
    ball.scene.meshFile = "cube";
    ASSERT_TRUE(readMeshOf(ball.scene));
    ball.scene.lights[0].direction = {0.0, 0.0, -1.0};
    EXPECT_FALSE(spotIn(ball.scene, ball.scene.lights[0], viewWidth, viewHeight));
}

} // namespace
} // namespace reflectance
