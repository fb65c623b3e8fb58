#include "tests/geometry/mesh_text.h"

#include <bit>
#include <gmock/gmock.h>

namespace reflectance::testing {
namespace {

using ::testing::HasSubstr;

void appendLittle(std::string& bytes, std::uint32_t value, int size)
{
    for (int i = 0; i < size; ++i)
        bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

void appendPoint(std::string& bytes, const Vec3d& p)
{
    for (const double component : {p.x, p.y, p.z})
        appendLittle(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(component)), 4);
}

/// Two triangles for each quad; the facet normals are left zero, as many programs do.
std::string binaryCube(const std::string& title, std::uint32_t announced = 12)
{
    std::string bytes = title + std::string(80 - title.size(), '\0');
    appendLittle(bytes, announced, 4);
    for (const auto& quad : cubeQuads())
        for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
            appendPoint(bytes, {});
            for (const int k : {a, b, c})
                appendPoint(bytes, cubeCorners()[static_cast<std::size_t>(quad[static_cast<std::size_t>(k)])]);
            appendLittle(bytes, 0, 2);
        }
    return bytes;
}

std::string asciiTriangle(const std::string& end = "endloop\nendfacet\n")
{
    return "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 2 0\n" + end;
}

TEST(Stl, MergesEqualPointsSoThatEdgesExist)
{
    const LoadedMesh cube = loaded(binaryCube("made by a test"), "cube.stl");
    EXPECT_EQ(cube.report.triangles, 12U);
    EXPECT_EQ(cube.report.fileVertices, 8U);
    EXPECT_EQ(cube.report.area, 24.0);
    EXPECT_EQ(cube.mesh->positions.size(), 24U) << "split again at the hard edges";
}

TEST(Stl, BinaryIsKnownBySizeEvenIfItSaysSolid)
{
    EXPECT_EQ(loaded(binaryCube("solid but binary"), "cube.stl").report.triangles, 12U);
    EXPECT_EQ(loaded(binaryCube("solid but binary"), "cube").report.triangles, 12U) << "without an extension";
}

TEST(Stl, WrongCountsAndTrailingBytesAreSurvived)
{
    const LoadedMesh less = loaded(binaryCube("x", 4'000'000'000U), "cube.stl");
    EXPECT_EQ(less.report.triangles, 12U);
    EXPECT_THAT(less.report.warnings.at(0).text, HasSubstr("ends before"));
    const LoadedMesh more = loaded(binaryCube("x") + "tail", "cube.stl");
    EXPECT_EQ(more.report.triangles, 12U);
    EXPECT_THAT(more.report.warnings.at(0).text, HasSubstr("after the last facet"));
}

TEST(Stl, OneBadVertexCostsOneFacet)
{
    std::string bytes = binaryCube("x");
    bytes.replace(84 + 12, 4, "\xFF\xFF\xFF\x7F"); // a NaN in the first facet
    const LoadedMesh cube = loaded(bytes, "cube.stl");
    EXPECT_EQ(cube.report.triangles, 11U);
    EXPECT_EQ(cube.report.droppedFaces(), 1U);
}

TEST(Stl, ReadsAscii)
{
    EXPECT_EQ(loaded(asciiTriangle() + "endsolid a b\n", "t.stl").report.area, 2.0);
    EXPECT_EQ(loaded(asciiTriangle("") + "endsolid", "t.stl").report.area, 2.0) << "a facet that is not closed";
    EXPECT_EQ(loaded(asciiTriangle() + asciiTriangle(), "t.stl").report.triangles, 2U) << "two solids";
    std::string upper = asciiTriangle();
    for (char& c : upper)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    EXPECT_EQ(loaded(upper, "t.stl").report.area, 2.0);
}

TEST(Stl, APlantedFaultIsNoticed)
{
    std::string text = asciiTriangle();
    text.replace(text.find("vertex 2 0 0"), 12, "vertex 2 0 x");
    EXPECT_THAT(refusal(text, "t.stl"), HasSubstr("not a finite point"));
}

} // namespace
} // namespace reflectance::testing
