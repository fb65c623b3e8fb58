// Hazard H61: a mesh a million units away from the origin looks like the same mesh at the origin.
#include "core/geometry/load.h"
#include "core/render/cpu/cpu_renderer.h"
#include "tests/render/sphere.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

/// The mesh as an OBJ text, moved by `offset` and scaled.
std::string objText(const Mesh& mesh, const Vec3d& offset, double scale)
{
    std::string text;
    char line[128];
    for (const Vec3d& p : mesh.positions) {
        std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", scale * p.x + offset.x, scale * p.y + offset.y,
                      scale * p.z + offset.z);
        text += line;
    }
    for (const Vec3d& n : mesh.normals) {
        std::snprintf(line, sizeof line, "vn %.17g %.17g %.17g\n", n.x, n.y, n.z);
        text += line;
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        std::snprintf(line, sizeof line, "f %u//%u %u//%u %u//%u\n", a + 1, a + 1, b + 1, b + 1, c + 1, c + 1);
        text += line;
    }
    return text;
}

Image picture(const Vec3d& offset, double scale)
{
    Scene scene = sphereScene("hybrid");
    const auto loaded = readMesh(objText(*scene.mesh, offset, scale), "sphere.obj");
    EXPECT_TRUE(loaded.has_value());
    scene.mesh = loaded.value().mesh;
    return renderOnCpu(scene, {96, 96, 2}, Precision::Double);
}

double largestDifference(const Image& a, const Image& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        largest = std::max(largest, std::fabs(double{a.rgb[i]} - double{b.rgb[i]}));
    return largest;
}

TEST(CpuOffset, APlaceFarAwayAndAnySizeChangeNothing)
{
    const Image centred = picture({}, 1.0);
    // A coordinate near 1e6 is known to 1.2e-10; on triangles 0.05 wide that turns the interpolation by 1e-8 at most,
    // and the highlight's slope is below 4.
    EXPECT_LE(largestDifference(picture({1e6, -1e6, 1e6}, 1.0), centred), 1e-7);
    EXPECT_LE(largestDifference(picture({}, 1e-12), centred), 1e-7);
    EXPECT_LE(largestDifference(picture({}, 1e12), centred), 1e-7);
    // The check sees a sphere that is a thousandth to the side of where it was: offsets do matter without centring.
    Scene moved = sphereScene("hybrid");
    moved.camera.eye.x += 1e-3;
    EXPECT_GT(largestDifference(renderOnCpu(moved, {96, 96, 2}, Precision::Double), centred), 1e-4);
}

} // namespace
} // namespace reflectance::test
