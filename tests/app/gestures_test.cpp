// What a hand does in the picture: no window, only positions.
#include "app/explorer/gestures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace reflectance::explorer {
namespace {

// A handle is computed on the cursor's own ray, so only rounding moves it: the sphere of directions is some 600 px
// wide, where 1e-6 px is 1e7 times the rounding of a double; near the silhouette a square root halves the digits.
constexpr double underTheCursor = 1e-6;

const ViewSize size{920, 724};

Light pointLight(Vec3d position)
{
    Light light;
    light.kind = LightKind::Point;
    light.position = position;
    return light;
}

double missed(const Light& light, const Camera& camera, Cursor cursor)
{
    const HandleView view = viewOf(light, camera, size);
    return std::hypot(view.x - cursor.x, view.y - cursor.y);
}

/// Radius in pixels of a handle's sphere about the middle of the picture, for a camera that looks at the origin.
double silhouettePixels(const Camera& camera, const Light& light = Light())
{
    const double angle = std::asin(handleSphere(light, camera, size).radius / length(camera.eye));
    return 0.5 * size.height * std::tan(angle) / std::tan(camera.fieldOfView * std::numbers::pi / 360.0);
}

Cursor fromMiddle(double radius, double angle)
{
    return {0.5 * size.width + radius * std::cos(angle), 0.5 * size.height + radius * std::sin(angle)};
}

TEST(Handles, FollowTheCursorOnBothHalves)
{
    const Camera camera;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 0.999), turn(0.0, 2.0 * std::numbers::pi);
    for (const Light& light : {Light(), pointLight({0.9, 0.7, -0.4})}) {
        const double radius = handleSphere(light, camera, size).radius;
        for (int i = 0; i < 500; ++i) {
            const Cursor cursor = fromMiddle(share(random) * silhouettePixels(camera, light), turn(random));
            for (const bool farHalf : {false, true}) {
                const Light held = heldAt(light, farHalf, camera, size, cursor);
                EXPECT_LT(missed(held, camera, cursor), underTheCursor);
                EXPECT_EQ(viewOf(held, camera, size).behind, farHalf);
                EXPECT_NEAR(length(handlePoint(held, camera, size)), radius,
                            2e-15); // a few roundings of a length near 1
            }
        }
    }
}

TEST(Handles, FollowTheCursorWhenTheViewIsPannedAndTilted)
{
    Camera camera = orbited(panned(Camera(), 0.21, -0.13), 1.1, 0.6);
    camera.fieldOfView = 60.0;
    const Cursor cursor = fromMiddle(47.0, -0.6); // the sphere of directions keeps to the picture's middle
    EXPECT_LT(missed(heldAt(Light(), false, camera, size, cursor), camera, cursor), underTheCursor);
    EXPECT_LT(missed(heldAt(Light(), true, camera, size, cursor), camera, cursor), underTheCursor);
}

TEST(Handles, OfDirectionalLightsNeverLeaveThePicture)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (const ViewSize view : {ViewSize{920, 724}, ViewSize{300, 900}, ViewSize{3000, 200}}) {
        for (int i = 0; i < 300; ++i) {
            Light light;
            light.direction = {any(random), any(random), any(random)};
            const Camera camera =
                zoomed(panned(orbited(Camera(), 3.0 * any(random), any(random)), any(random), any(random)),
                       std::exp(2.0 * any(random)));
            const HandleView handle = viewOf(light, camera, view);
            EXPECT_TRUE(handle.visible);
            EXPECT_TRUE(handle.x > 0.0 && handle.x < view.width && handle.y > 0.0 && handle.y < view.height)
                << handle.x << ", " << handle.y;
        }
    }
}

TEST(Handles, RollOverTheSilhouetteAndBack)
{
    const Camera camera;
    const double edge = silhouettePixels(camera);
    const Light inside = heldAt(Light(), false, camera, size, fromMiddle(edge - 0.01, 0.4));
    const Light outside = heldAt(Light(), false, camera, size, fromMiddle(edge + 0.01, 0.4));
    EXPECT_FALSE(viewOf(inside, camera, size).behind);
    EXPECT_TRUE(viewOf(outside, camera, size).behind);
    // 0.01 px off a silhouette of 300 px lies sqrt(2 * 0.01 / 300) = 0.008 rad on either side of the edge.
    EXPECT_LT(length(inside.direction - outside.direction), 0.03);

    const Light far = heldAt(Light(), false, camera, size, fromMiddle(edge + 60.0, 0.4));
    const HandleView view = viewOf(far, camera, size);
    EXPECT_TRUE(view.behind);
    EXPECT_LT(std::hypot(view.x - 0.5 * size.width, view.y - 0.5 * size.height), edge - 40.0);
    // Taken from the far half, the same way leads back to the near one.
    EXPECT_FALSE(viewOf(heldAt(Light(), true, camera, size, fromMiddle(edge + 60.0, 0.4)), camera, size).behind);
}

TEST(Handles, StayFiniteForAnyCursorAndFromInside)
{
    Camera inside; // of a point light's sphere
    inside.eye = {0.3, 0.2, 0.5};
    const Light light = pointLight({0.0, 2.0, 0.0});
    for (const Camera& camera : {Camera(), inside}) {
        for (const double x : {-1e6, -10.0, 0.0, 460.0, 1e4, 1e7}) {
            // Two roundings of a unit vector, and of one of length 2.
            EXPECT_NEAR(length(heldAt(Light(), false, camera, size, {x, 300.0}).direction), 1.0, 1e-15);
            EXPECT_NEAR(length(heldAt(light, false, camera, size, {x, 300.0}).position), 2.0, 2e-15);
        }
    }
    const Cursor cursor{500.0, 200.0};
    EXPECT_LT(missed(heldAt(light, false, inside, size, cursor), inside, cursor), underTheCursor);
}

TEST(Handles, AreFoundNearestFirstAndNearHalfFirst)
{
    const Camera camera;
    const Cursor place = fromMiddle(50.0, 1.0);
    std::vector<Light> lights{heldAt(Light(), true, camera, size, place), heldAt(Light(), false, camera, size, place)};
    EXPECT_EQ(handleAt(lights, camera, size, place, 12.0), 1);
    std::swap(lights[0], lights[1]);
    EXPECT_EQ(handleAt(lights, camera, size, place, 12.0), 0);
    EXPECT_EQ(handleAt(lights, camera, size, {place.x + 30.0, place.y}, 12.0), -1);
    EXPECT_EQ(handleAt({}, camera, size, place, 12.0), -1);
}

TEST(Handles, BehindTheEyeAreNotOffered)
{
    const Camera camera;
    const std::vector<Light> lights{pointLight(2.0 * camera.eye)};
    EXPECT_FALSE(viewOf(lights[0], camera, size).visible);
    EXPECT_EQ(handleAt(lights, camera, size, {460.0, 362.0}, 1e9), -1);
}

TEST(RolledLight, FollowsTheHandInFrontAndKeepsItsDistance)
{
    const Camera camera;
    const CameraFrame frame = frameOf(camera);
    Light light;
    light.direction = frame.back;
    const Light right = rolled(light, camera, size, 50.0, 0.0);
    EXPECT_GT(dot(right.direction, frame.right), 0.1);
    EXPECT_NEAR(dot(right.direction, frame.up), 0.0, 1e-15); // rotation about `up` leaves this at rounding
    const Light down = rolled(light, camera, size, 0.0, 50.0);
    EXPECT_LT(dot(down.direction, frame.up), -0.1);

    const Light point = rolled(pointLight({2.0, 2.4, 2.0}), camera, size, 33.0, -71.0);
    EXPECT_NEAR(length(point.position), length(Vec3d(2.0, 2.4, 2.0)), 1e-14); // roundings of a length near 4
    EXPECT_EQ(rolled(light, camera, size, 0.0, 0.0), light);
}

TEST(ReachedLight, HalvesDistanceOrDoublesIntensityPerHundredPixels)
{
    const Light nearer = reached(pointLight({0.0, 3.0, 0.0}), -100.0);
    EXPECT_DOUBLE_EQ(nearer.position.y, 1.5);
    EXPECT_EQ(nearer.intensity, Vec3d(1.0));
    const Light brighter = reached(Light(), -100.0);
    EXPECT_EQ(brighter.intensity, Vec3d(2.0));
    EXPECT_EQ(brighter.direction, Light().direction);
    EXPECT_LE(length(reached(pointLight({0.0, 3.0, 0.0}), 1e9).position), 100.0);
    EXPECT_GE(length(reached(pointLight({0.0, 3.0, 0.0}), -1e9).position), 0.05);
    EXPECT_LE(reached(Light(), -1e9).intensity.x, 1e6);
}

TEST(CameraDrags, TurnAndMoveTheObjectWithTheHand)
{
    const Camera camera;
    const Vec3d front = frameOf(camera).back; // the object's point that faces the eye
    const auto x = [&](const Camera& c) { return projected(c, front, size.width, size.height).x; };
    const auto y = [&](const Camera& c) { return projected(c, front, size.width, size.height).y; };
    EXPECT_GT(x(orbitedByDrag(camera, size, 20.0, 0.0)), x(camera));
    EXPECT_GT(y(orbitedByDrag(camera, size, 0.0, 20.0)), y(camera));

    const Camera moved = pannedByDrag(camera, size, 31.0, -17.0);
    const Vec3d origin = projected(moved, {}, size.width, size.height);
    EXPECT_NEAR(origin.x, 0.5 * size.width + 31.0, 1e-9); // exact but for rounding of 1e3-sized pixel coordinates
    EXPECT_NEAR(origin.y, 0.5 * size.height - 17.0, 1e-9);

    EXPECT_LT(length(zoomedByWheel(camera, 1.0).eye), length(camera.eye));
    EXPECT_NEAR(length(zoomedByWheel(zoomedByWheel(camera, 3.0), -3.0).eye), length(camera.eye),
                1e-14); // roundings near 3
    EXPECT_NEAR(length(zoomedByDrag(camera, -200.0).eye), 0.5 * length(camera.eye), 1e-14);
}

TEST(Strokes, AreChosenByButtonAndModifiers)
{
    const std::vector<Light> lights(2);
    const Camera camera;
    const auto kind = [&](MouseButton button, Modifiers modifiers, int handle, int selected = 0) {
        return strokeFrom(button, modifiers, {10.0, 10.0}, handle, selected, lights, camera, size).kind;
    };
    using Kind = Stroke::Kind;
    EXPECT_EQ(kind(MouseButton::Left, {}, -1), Kind::Orbit);
    EXPECT_EQ(kind(MouseButton::Left, {}, 1), Kind::HoldLight);
    EXPECT_EQ(kind(MouseButton::Left, {.shift = true}, -1), Kind::Pan);
    EXPECT_EQ(kind(MouseButton::Middle, {}, -1), Kind::Pan);
    EXPECT_EQ(kind(MouseButton::Left, {.shift = true, .control = true}, 1), Kind::RollLight);
    EXPECT_EQ(kind(MouseButton::Right, {.shift = true, .control = true}, -1), Kind::ReachLight);
    EXPECT_EQ(kind(MouseButton::Right, {}, -1), Kind::Zoom);
    EXPECT_EQ(kind(MouseButton::Left, {.shift = true, .control = true}, -1, -1), Kind::Pan);
}

TEST(Strokes, AClickChangesNothingAndAReturnUndoes)
{
    const Camera camera;
    const std::vector<Light> lights(1);
    const HandleView handle = viewOf(lights[0], camera, size);
    const Cursor press{handle.x + 3.0, handle.y - 2.0};
    const Stroke stroke = strokeFrom(MouseButton::Left, {}, press, 0, 0, lights, camera, size);
    EXPECT_EQ(lightOf(stroke, size, press), lights[0]);
    const Light dragged = lightOf(stroke, size, {press.x + 25.0, press.y + 5.0});
    EXPECT_LT(missed(dragged, camera, {handle.x + 25.0, handle.y + 5.0}), underTheCursor);

    const Stroke orbit = strokeFrom(MouseButton::Left, {}, press, -1, 0, lights, camera, size);
    EXPECT_NE(cameraOf(orbit, size, {0.0, 0.0}), camera);
    // The elevation passes through asin and cos once: a few roundings of a distance near 3.
    EXPECT_LT(length(cameraOf(orbit, size, press).eye - camera.eye), 1e-14);
}

TEST(Strokes, ThisSuiteCatchesAMisplacedHandle)
{
    // Planted fault: a light taken by the direction of the ray across the view instead of the point on the sphere.
    const Camera camera;
    const Cursor cursor = fromMiddle(120.0, 2.0);
    Light wrong;
    wrong.direction =
        normalized(rayThrough(camera, cursor.x, cursor.y, size.width, size.height) + frameOf(camera).back);
    EXPECT_GT(missed(wrong, camera, cursor), underTheCursor);
}

} // namespace
} // namespace reflectance::explorer
