#include "tests/geometry/mesh_text.h"

#include <gmock/gmock.h>

namespace reflectance::testing {
namespace {

using ::testing::HasSubstr;

std::string offCube(const std::string& head, const std::string& vertexExtra = "", const std::string& faceExtra = "")
{
    std::string text = head;
    for (const Vec3d& p : cubeCorners())
        text += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + vertexExtra + "\n";
    for (const auto& quad : cubeQuads()) {
        text += "4";
        for (const int corner : quad)
            text += " " + std::to_string(corner);
        text += faceExtra + "\n";
    }
    return text;
}

void expectCube(const std::string& text, const std::string& what)
{
    const LoadedMesh cube = loaded(text, "cube.off");
    EXPECT_EQ(cube.report.triangles, 12U) << what;
    EXPECT_EQ(cube.report.area, 24.0) << what;
    EXPECT_TRUE(cube.report.warnings.empty()) << what;
}

TEST(Off, ReadsEveryWriting)
{
    expectCube(offCube("OFF\n8 6 12\n"), "plain");
    expectCube(offCube("OFF\n8 6\n"), "without the count of edges");
    expectCube(offCube("OFF 8 6 12\n"), "counts on the first line");
    expectCube(offCube("OFF8 6 12\n"), "counts right behind the word");
    expectCube(offCube("8 6 12\n"), "without the word");
    expectCube(offCube("# a cube\nOFF # really\n\n# counts\n8 6 12\n\n"), "comments and blank lines");
    expectCube(offCube("OFF\r\n8 6 12\r\n", "\r", " 3 255 0 0\r"), "CRLF and colours of faces");
    expectCube(offCube("COFF\n8 6 12\n", " 255 0 0 255", " 0.5 0.5 0.5"), "COFF");
    expectCube(offCube("STOFF\n8 6 12\n", " 0.5 0.5"), "STOFF");
    expectCube(offCube("OFF\n8 6 12\n", " 0 0 1"), "more numbers than a plain vertex has");
}

TEST(Off, ReadsNormals)
{
    const LoadedMesh m = loaded("NOFF\n3 1 0\n0 0 0 0 0 5\n1 0 0 0 0 5\n0 1 0 0 0 5\n3 0 1 2\n", "a.off");
    EXPECT_EQ(m.report.cornersWithFileNormal, 3U);
    EXPECT_EQ(m.mesh->normals[0], Vec3d(0, 0, 1));
}

TEST(Off, RefusesByNameWhatItCannotRead)
{
    EXPECT_THAT(refusal("4OFF\n1 1 0\n", "a.off"), HasSubstr("\"4OFF\" is no OFF variant"));
    EXPECT_THAT(refusal("OFF BINARY\n1 1 0\n", "a.off"), HasSubstr("binary OFF"));
    EXPECT_THAT(refusal("OFF\nmany\n", "a.off"), HasSubstr("a.off:2: the counts"));
    EXPECT_THAT(refusal("OFF\n-3 1 0\n", "a.off"), HasSubstr("counts"));
}

TEST(Off, APlantedFaultIsNoticed)
{
    std::string text = offCube("OFF\n8 6 12\n");
    text.replace(text.find("4 0 3 2 1"), 9, "4 0 3 2 8");
    const LoadedMesh cube = loaded(text, "cube.off");
    EXPECT_EQ(cube.report.triangles, 10U);
    EXPECT_EQ(cube.report.warnings.at(0).line, 11);
}

} // namespace
} // namespace reflectance::testing
