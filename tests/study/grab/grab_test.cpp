// The peak of the rendered picture lies under the cursor, for any camera, mesh and kind of light; a terminator and an edge
// run through it.
#include "tests/study/grab/views.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

struct Pixel {
    int x = -1, y = -1;
};

/// The brightest pixel of the picture in double, one sample in the middle of each.
Pixel brightest(const Scene& scene)
{
    const RenderSettings settings{viewWidth, viewHeight, 1};
    const Image image = renderOnCpu(scene, settings, Precision::Double);
    const auto at = [&](std::size_t pixel) { return image.rgb[3 * pixel]; };
    std::size_t best = 0;
    for (std::size_t i = 1; i < image.rgb.size() / 3; ++i)
        if (at(i) > at(best))
            best = i;
    return {static_cast<int>(best % viewWidth), static_cast<int>(best / viewWidth)};
}

double distance(Pixel pixel, const ProbedPoint& cursor)
{
    return std::hypot(pixel.x + 0.5 - cursor.x, pixel.y + 0.5 - cursor.y);
}

template <class Move> void forRandomViews(LightKind kind, Move move)
{
    std::mt19937_64 random(5);
    for (const std::string mesh : {"sphere", "mug", "torus_knot"})
        for (int view = 0; view < 8; ++view) {
            Scene scene = glossyView(mesh, kind, random);
            ASSERT_TRUE(scene.mesh) << mesh;
            if (const auto cursor = anyPoint(scene, random))
                move(scene, *cursor);
        }
}

class Grab : public testing::TestWithParam<LightKind> {};
INSTANTIATE_TEST_SUITE_P(Lights, Grab, testing::Values(LightKind::Directional, LightKind::Point));

TEST_P(Grab, TheSpotPeaksUnderTheCursor)
{
    int looked = 0;
    forRandomViews(GetParam(), [&](Scene& scene, const ProbedPoint& cursor) {
        const auto moved = withSpotAt(scene.lights[0], scene.camera.eye, cursor, SpotKind::Mirrored);
        ASSERT_TRUE(moved);
        scene.lights[0] = *moved;
        // The cursor is on a sample, where R.V is 1 but for rounding: another pixel can only be as bright.
        EXPECT_LE(distance(brightest(scene), cursor), 1.0) << scene.meshFile;
        ++looked;
    });
    EXPECT_GT(looked, 20);
}

TEST_P(Grab, TheTestSeesALightThatIsThreeDegreesOff) // planted
{
    int missed = 0, looked = 0;
    forRandomViews(GetParam(), [&](Scene& scene, const ProbedPoint& cursor) {
        const Light moved = *withSpotAt(scene.lights[0], scene.camera.eye, cursor, SpotKind::Mirrored);
        scene.lights[0] = moved;
        scene.lights[0].direction += 0.05 * normalized(cross(moved.direction, cursor.N) + Vec3d(1e-9, 0.0, 0.0));
        scene.lights[0].position += 0.15 * normalized(cross(moved.position, cursor.N) + Vec3d(1e-9, 0.0, 0.0));
        missed += distance(brightest(scene), cursor) > 1.0 ? 1 : 0;
        ++looked;
    });
    EXPECT_GT(missed, looked / 2);
}

TEST_P(Grab, ThePointIsTheSpotOfAMatteSurface)
{
    forRandomViews(GetParam(), [&](Scene& scene, const ProbedPoint& cursor) {
        scene.surface.model = "lambert";
        ASSERT_EQ(spotKindOf(scene), SpotKind::Facing);
        const Light moved = *withSpotAt(scene.lights[0], scene.camera.eye, cursor, SpotKind::Facing);
        // Two normalisations and a difference of places near 1.
        EXPECT_NEAR(dot(arrivalAt(moved, cursor.P).L, cursor.N), 1.0, 1e-12);
    });
}

TEST_P(Grab, TheTerminatorRunsThroughTheCursor)
{
    forRandomViews(GetParam(), [&](Scene& scene, const ProbedPoint& cursor) {
        const Light before = scene.lights[0];
        const auto moved = withTerminatorAt(before, cursor);
        ASSERT_TRUE(moved);
        EXPECT_NEAR(dot(arrivalAt(*moved, cursor.P).L, cursor.N), 0.0, 1e-12); // roundings of numbers near 1
        if (before.kind == LightKind::Point) {
            EXPECT_NEAR(length(moved->position), length(before.position), 1e-12);
        }
        EXPECT_EQ(withTerminatorAt(*moved, cursor)->kind, before.kind);
        // A light that is where it should be stays.
        EXPECT_NEAR(length(withTerminatorAt(*moved, cursor)->direction - moved->direction), 0.0, 1e-12);
        EXPECT_NEAR(length(withTerminatorAt(*moved, cursor)->position - moved->position), 0.0, 1e-12);
    });
}

TEST(GrabPoint, KeepsItsDistanceFromTheOriginOrFromTheSurface)
{
    std::mt19937_64 random(3);
    Scene scene = glossyView("sphere", LightKind::Point, random);
    const auto cursor = anyPoint(scene, random);
    ASSERT_TRUE(cursor);
    const Light moved = *withSpotAt(scene.lights[0], scene.camera.eye, *cursor, SpotKind::Mirrored);
    EXPECT_NEAR(length(moved.position), 3.0, 1e-12);
    Light inside = scene.lights[0];
    inside.position = 0.2 * cursor->P; // a light within the sphere cannot stay at its distance and shine on it
    const Light out = *withSpotAt(inside, scene.camera.eye, *cursor, SpotKind::Mirrored);
    EXPECT_NEAR(length(out.position - cursor->P), length(inside.position - cursor->P), 1e-12);
}

TEST(GrabErrors, SayInASentenceWhatToDo)
{
    ProbedPoint edgeOn;
    edgeOn.N = {0.0, 0.0, 1.0};
    const auto grazing = withSpotAt(Light(), {5.0, 0.0, 0.0}, edgeOn, SpotKind::Mirrored);
    ASSERT_FALSE(grazing);
    EXPECT_EQ(grazing.error().sentence(),
              "the surface is seen from its edge there; aim at a part that faces the camera");
    EXPECT_FALSE(withSpotAt(Light(), {0.0, 0.0, -5.0}, edgeOn, SpotKind::Mirrored)) << "from behind";
    EXPECT_FALSE(withSpotAt(Light(), edgeOn.P, edgeOn, SpotKind::Mirrored)) << "the eye in the surface";
    Light above;
    above.direction = edgeOn.N;
    EXPECT_FALSE(withTerminatorAt(above, edgeOn));
}

} // namespace
} // namespace reflectance
