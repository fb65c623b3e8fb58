#include "core/geometry/camera.h"

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

namespace reflectance::testing {
namespace {

constexpr int width = 640;
constexpr int height = 480;

std::vector<Camera> cameras()
{
    return {Camera{}, Camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 20.0},
            Camera{{-3, 2, -1}, {0.2, 0.1, -0.3}, {0, 0, 1}, 90.0},
            Camera{{0, 4, 0}, {0, 0, 0}, {0, 1, 0}, 35.0}}; // looks straight down along `up`
}

TEST(Camera, RaysLeadToWhatIsProjected)
{
    for (const Camera& camera : cameras())
        for (const auto& [x, y] :
             {std::pair(0.5, 0.5), std::pair(320.0, 240.0), std::pair(631.25, 17.0), std::pair(100.0, 479.5)}) {
            const Vec3d there = camera.eye + 2.5 * rayThrough(camera, x, y, width, height);
            const Vec3d back = projected(camera, there, width, height);
            EXPECT_NEAR(back.x, x, 1e-10); // some ten roundings of numbers below 1000
            EXPECT_NEAR(back.y, y, 1e-10);
            EXPECT_GT(back.z, 0.0);
        }
}

TEST(Camera, APlantedShiftOfHalfAPixelIsNoticed)
{
    const Camera camera;
    const Vec3d there = camera.eye + rayThrough(camera, 100.5, 100.0, width, height);
    EXPECT_GT(std::fabs(projected(camera, there, width, height).x - 100.0), 0.4);
}

TEST(Camera, MatricesAgreeWithProjection)
{
    for (const Camera& camera : cameras()) {
        const glm::dmat4 clip = clipFromView(camera, static_cast<double>(width) / height) * viewFromWorld(camera);
        for (const Vec3d& p : {Vec3d(0, 0, 0), Vec3d(0.5, -0.2, 0.3), Vec3d(-0.6, 0.7, 0.1)}) {
            const glm::dvec4 h = clip * glm::dvec4(p.x, p.y, p.z, 1.0);
            const Vec3d image = projected(camera, p, width, height);
            EXPECT_NEAR((h.x / h.w + 1.0) * 0.5 * width, image.x, 1e-10); // as above
            EXPECT_NEAR((1.0 - h.y / h.w) * 0.5 * height, image.y, 1e-10);
            EXPECT_NEAR(h.w, image.z, 1e-12);
        }
    }
}

TEST(Camera, NearAndFarEncloseTheUnitSphere) // hazard H60
{
    for (const Camera& camera : cameras()) {
        const glm::dmat4 clip = clipFromView(camera, 1.0) * viewFromWorld(camera);
        const Vec3d along = normalized(camera.eye);
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec4 h = clip * glm::dvec4(side * along.x, side * along.y, side * along.z, 1.0);
            EXPECT_LT(std::fabs(h.z), h.w) << "the nearest and the farthest point of the sphere are both drawn";
        }
    }
}

TEST(Camera, FrameIsOrthonormalEvenLookingAlongUp)
{
    for (const Camera& camera : cameras()) {
        const CameraFrame f = frameOf(camera);
        for (const Vec3d& axis : {f.right, f.up, f.back})
            EXPECT_NEAR(length(axis), 1.0, 1e-14);
        EXPECT_NEAR(dot(f.right, f.up), 0.0, 1e-14);
        EXPECT_NEAR(dot(f.up, f.back), 0.0, 1e-14);
        EXPECT_NEAR(length(cross(f.right, f.up) - f.back), 0.0, 1e-14);
    }
}

TEST(Camera, OrbitKeepsDistanceAndStaysOffThePoles)
{
    for (const Camera& camera : cameras()) {
        const double distance = length(camera.eye - camera.target);
        const Camera turned = orbited(camera, 0.7, 0.2);
        EXPECT_NEAR(length(turned.eye - turned.target), distance, 1e-13);
        const Camera over = orbited(camera, 0.0, 10.0);
        const double cosine = dot(normalized(over.eye - over.target), normalized(over.up));
        EXPECT_NEAR(cosine, std::cos(0.5 * 3.14159265358979 / 180.0), 1e-9); // 0.5 degrees short of the pole
    }
}

TEST(Camera, OrbitThereAndBackIsWhereItBegan)
{
    const Camera camera;
    const Camera back = orbited(orbited(camera, 0.8, -0.3), -0.8, 0.3);
    EXPECT_NEAR(length(back.eye - camera.eye), 0.0, 1e-13);
}

TEST(Camera, PanMovesThePictureByThatMuch)
{
    const Camera camera;
    const Vec3d before = projected(camera, camera.target, width, height);
    const Vec3d after = projected(panned(camera, 0.25, 0.1), camera.target, width, height);
    EXPECT_NEAR(after.x - before.x, 0.25 * height, 1e-9); // the hand drags the object along
    EXPECT_NEAR(after.y - before.y, 0.1 * height, 1e-9);
}

TEST(Camera, ZoomIsLimited)
{
    const Camera camera;
    EXPECT_NEAR(length(zoomed(camera, 0.5).eye - camera.target), 0.5 * length(camera.eye - camera.target), 1e-13);
    EXPECT_NEAR(length(zoomed(camera, 1e-9).eye - camera.target), 0.05, 1e-13);
    EXPECT_NEAR(length(zoomed(camera, 1e9).eye - camera.target), 1000.0, 1e-9);
}

TEST(Camera, FramingShowsTheWholeUnitSphere)
{
    for (const double aspect : {0.5, 1.0, 16.0 / 9.0}) {
        const Camera framedCamera = framed(Camera{}, aspect);
        const int across = static_cast<int>(1000 * aspect);
        const CameraFrame f = frameOf(framedCamera);
        const double distance = length(framedCamera.eye);
        // The outline of the sphere seen from this distance: a circle nearer than the centre.
        const double radius = std::sqrt(1.0 - 1.0 / (distance * distance));
        for (const Vec3d& axis : {f.right, f.up, -f.right, -f.up}) {
            const Vec3d p = projected(framedCamera, radius * axis + (1.0 / distance) * f.back, across, 1000);
            EXPECT_TRUE(p.x >= 0 && p.x <= across && p.y >= 0 && p.y <= 1000) << aspect;
        }
    }
}

} // namespace
} // namespace reflectance::testing
