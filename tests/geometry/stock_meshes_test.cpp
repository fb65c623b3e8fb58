// The meshes that travel with the program: what they promise, and that they are what tools/make_meshes writes.
#include "core/base/embedded.h"
#include "core/geometry/topology.h"
#include "tests/geometry/mesh_text.h"
#include "tools/meshes/stock.h"

#include <gmock/gmock.h>
#include <numbers>

namespace reflectance::testing {
namespace {

LoadedMesh stockMesh(const std::string& name)
{
    auto mesh = loadStockOrFile(name);
    EXPECT_TRUE(mesh) << name;
    return mesh ? *std::move(mesh) : LoadedMesh{std::make_shared<Mesh>(), {}};
}

TEST(StockMeshes, AreAllThere)
{
    EXPECT_THAT(stockMeshNames(),
                ::testing::ElementsAre("cube", "mug", "sphere", "teapot", "torus_knot", "vase", "wavy_plane"));
}

TEST(StockMeshes, AreCleanAndSmall)
{
    for (const std::string& name : stockMeshNames()) {
        const LoadedMesh m = stockMesh(name);
        EXPECT_LT(embeddedText("meshes/" + name + ".obj").size(), 1'000'000U) << name;
        EXPECT_TRUE(m.report.warnings.empty()) << name << ": " << m.report.warnings[0].text;
        EXPECT_EQ(m.report.cornersWithFileNormal, 3 * m.report.triangles) << name;
        EXPECT_EQ(m.report.unusedVertices, 0U) << name;
        EXPECT_EQ(m.mesh->name, name);
    }
}

TEST(StockMeshes, NormalsAgreeWithTheSurface)
{
    for (const std::string& name : stockMeshNames()) {
        const LoadedMesh m = stockMesh(name);
        const auto& p = m.mesh->positions;
        for (const Mesh::Triangle& t : m.mesh->triangles) {
            const Vec3d face = normalized(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
            for (const std::uint32_t v : t)
                // Smooth shapes lean by a few degrees only; the tip of the teapot's spout curls so tightly that its
                // facets lean by 55.
                EXPECT_GT(dot(m.mesh->normals[v], face), name == "teapot" ? 0.5 : 0.85) << name;
        }
    }
}

TEST(StockMeshes, AreClosedWhereTheyShouldBe)
{
    const auto summary = [](const std::string& name) { return Topology(*stockMesh(name).mesh).summary(); };
    for (const char* name : {"sphere", "cube", "vase"}) {
        EXPECT_TRUE(summary(name).isClosed()) << name;
        EXPECT_EQ(summary(name).eulerCharacteristic(), 2) << name;
    }
    EXPECT_TRUE(summary("torus_knot").isClosed());
    EXPECT_EQ(summary("torus_knot").eulerCharacteristic(), 0);
    EXPECT_EQ(summary("wavy_plane").boundaryLoops, 1U);
    EXPECT_EQ(summary("mug").components, 2U) << "the body and the handle that enters its wall";
    EXPECT_EQ(summary("mug").boundaryLoops, 2U) << "the handle's ends, inside the wall";
    for (const std::string& name : stockMeshNames()) {
        EXPECT_EQ(summary(name).nonManifoldEdges, 0U) << name;
        EXPECT_EQ(summary(name).windingConflicts, 0U) << name;
    }
}

TEST(StockMeshes, TheSphereIsASphere)
{
    const LoadedMesh sphere = stockMesh("sphere");
    EXPECT_NEAR(sphere.report.area, 4.0 * std::numbers::pi, 0.01); // 128 x 64 facets: 0.05 % less than the sphere
    for (std::size_t i = 0; i < sphere.mesh->positions.size(); ++i)
        EXPECT_LT(length(sphere.mesh->positions[i] - sphere.mesh->normals[i]), 2e-4); // both written with four decimals
}

TEST(StockMeshes, AreWhatTheGeneratorWrites)
{
    for (const stock::StockMesh& mesh : stock::all()) {
        const LoadedMesh kept = stockMesh(mesh.name);
        const LoadedMesh made = loaded(stock::objText(mesh.make(), mesh.title, mesh.decimals), mesh.name + ".obj");
        ASSERT_EQ(made.mesh->positions.size(), kept.mesh->positions.size()) << mesh.name;
        EXPECT_EQ(made.report.triangles, kept.report.triangles) << mesh.name;
        for (std::size_t i = 0; i < made.mesh->positions.size(); ++i)
            // Another compiler's sine may turn the last decimal: one unit of it, relative to a size of 1 to 9.
            ASSERT_LT(length(made.mesh->positions[i] - kept.mesh->positions[i]), 1e-3) << mesh.name;
    }
}

TEST(StockMeshes, APlantedDentWouldBeNoticed)
{
    stock::Shape dented = stock::sphere();
    dented.points[100].position = 0.9 * dented.points[100].position;
    const LoadedMesh made = loaded(stock::objText(dented, "dented", 4), "sphere.obj");
    EXPECT_GT(length(made.mesh->positions[100] - stockMesh("sphere").mesh->positions[100]), 1e-3);
}

} // namespace
} // namespace reflectance::testing
