// Meshes far from the origin, tiny and huge ones look like any other (hazard H61).
#include "tests/geometry/mesh_text.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance::testing {
namespace {

struct Place {
    double scale;
    Vec3d offset;
    double tolerance; ///< of positions and normals, from the spacing of doubles at the offset relative to the size
};

TEST(Placement, OffsetAndScaleDoNotShow)
{
    const LoadedMesh plain = loaded(sphereObj(24, 48));
    const std::vector<Place> places{
        {1.0, {1e7, -1e7, 1e7}, 1e-7}, // spacing at 1e7 is 2e-9; a facet is 0.06 wide: normals turn by 2e-9/0.06
        {1e-3, {100, 0, 0}, 1e-9},     // 1.4e-14 / 6e-5
        {1e-20, {}, 1e-13},            // rounding alone
        {1e30, {}, 1e-13},             // squares of 1e30 do not fit a float
        {1e-200, {}, 1e-13},           // nor those of 1e-200 a double
        {1e200, {}, 1e-13},
    };
    for (const Place& place : places) {
        const LoadedMesh moved = loaded(sphereObj(24, 48, place.scale, place.offset));
        ASSERT_EQ(moved.mesh->positions.size(), plain.mesh->positions.size()) << place.scale;
        for (std::size_t i = 0; i < plain.mesh->positions.size(); ++i) {
            EXPECT_LT(length(moved.mesh->positions[i] - plain.mesh->positions[i]), place.tolerance) << place.scale;
            EXPECT_LT(length(moved.mesh->normals[i] - plain.mesh->normals[i]), place.tolerance) << place.scale;
        }
        EXPECT_NEAR(moved.mesh->placement.scale / place.scale, 1.0, place.tolerance);
        EXPECT_NEAR(drawnArea(*moved.mesh), drawnArea(*plain.mesh), 10.0 * place.tolerance);
    }
}

TEST(Placement, LeadsBackToTheFile)
{
    const LoadedMesh m = loaded("v 10 20 30\nv 14 20 30\nv 10 23 30\nv 900 900 900\nf 1 2 3\n");
    EXPECT_EQ(m.mesh->placement.centre, Vec3d(12, 21.5, 30)) << "the unused vertex does not count";
    EXPECT_EQ(m.mesh->placement.scale, 2.5);
    EXPECT_EQ(m.report.unusedVertices, 1U);
    EXPECT_EQ(m.report.lowest, Vec3d(10, 20, 30));
    EXPECT_EQ(m.report.highest, Vec3d(14, 23, 30));
    const Vec3d back = m.mesh->placement.centre + m.mesh->placement.scale * m.mesh->positions[1];
    EXPECT_NEAR(length(back - Vec3d(14, 20, 30)), 0.0, 1e-14); // two roundings of numbers near 20
}

TEST(Placement, FillsTheUnitSphere)
{
    const LoadedMesh cube = loaded(cubeVertices() + cubeFaces());
    double farthest = 0.0;
    for (const Vec3d& p : cube.mesh->positions)
        farthest = std::max(farthest, length(p));
    EXPECT_NEAR(farthest, 1.0, 1e-15); // one division
    EXPECT_EQ(cube.report.area, 24.0) << "the report speaks in the file's units";
    EXPECT_NEAR(drawnArea(*cube.mesh), 8.0, 1e-14) << "24 / 3: drawn smaller by the radius, sqrt(3)";
}

TEST(Placement, FloatWouldNotDo)
{
    // The planted fault: the same sphere read through float is in ruins, which the tolerance above would not accept.
    const LoadedMesh plain = loaded(sphereObj(24, 48));
    double worst = 0.0;
    for (const Vec3d& p : plain.mesh->positions) {
        const float x = static_cast<float>(p.x + 1e7);
        worst = std::max(worst, std::fabs(static_cast<double>(x) - 1e7 - p.x));
    }
    EXPECT_GT(worst, 0.1);
}

} // namespace
} // namespace reflectance::testing
