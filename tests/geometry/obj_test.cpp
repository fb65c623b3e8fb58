// What real OBJ files do, each in a few lines.
#include "tests/geometry/mesh_text.h"

#include <gmock/gmock.h>

namespace reflectance::testing {
namespace {

using ::testing::HasSubstr;

/// Every way of writing it must give the same cube: 12 triangles, area 24, nothing to complain about.
struct Writing {
    const char* what;
    std::string text;
};

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

std::vector<Writing> writings()
{
    const std::string plain = cubeVertices() + cubeFaces();
    const std::string negative =
        cubeVertices() + "f -8 -5 -6 -7\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -6 -5 -1 -2\nf -8 -4 -1 -5\nf -7 -6 -2 -3\n";
    return {
        {"plain", plain},
        {"CRLF line ends", replaced(plain, "\n", "\r\n")},
        {"CR line ends", replaced(plain, "\n", "\r")},
        {"byte order mark before a vertex", "\xEF\xBB\xBF" + plain},
        {"no line end at the end", plain.substr(0, plain.size() - 1)},
        {"negative indices", negative},
        {"faces before vertices", cubeFaces() + cubeVertices()},
        {"comments behind the data", replaced(plain, "\n", " # 9 9 9\n")},
        {"a comment that ends in a backslash", "# C:\\models\\\n" + plain},
        {"a backslash that continues a face", replaced(plain, "f 1 4", "f 1 \\\n 4")},
        {"a backslash and CRLF", replaced(replaced(plain, "f 1 4", "f 1 \\\n 4"), "\n", "\r\n")},
        {"tabs and many blanks", replaced(plain, " ", " \t  ")},
        {"blanks before the keyword", replaced(plain, "v ", "  v ")},
        {"plus signs", replaced(plain, " 1", " +1")},
        {"exponents", replaced(plain, " 1 -1", " 10e-1 -0.1E+1")},
        {"colours behind the vertex", replaced(plain, "\nv ", " 0.5 0.5 0.5\nv ")},
        {"texture indices that do not exist", replaced(plain, "f 1 4 3 2", "f 1/7 4/8 3/9 2/99")},
        {"empty texture and normal places", replaced(plain, "f 1 4 3 2", "f 1/ 4/ 3// 2//")},
        {"groups, smoothing, materials, objects", "mtllib none.mtl\no cube\ng side\ns 1\nusemtl clay\n" + plain},
        {"an old free-form keyword", replaced(plain, "f ", "fo ")},
    };
}

TEST(Obj, ReadsEveryWritingOfACube)
{
    for (const Writing& writing : writings()) {
        const LoadedMesh cube = loaded(writing.text);
        EXPECT_EQ(cube.report.triangles, 12U) << writing.what;
        EXPECT_EQ(cube.report.area, 24.0) << writing.what; // right angles of length 2: exact
        EXPECT_EQ(cube.report.droppedFaces(), 0U) << writing.what;
        EXPECT_TRUE(cube.report.warnings.empty()) << writing.what << ": " << cube.report.warnings.front().text;
    }
}

TEST(Obj, APlantedFaultIsNoticed)
{
    const LoadedMesh cube = loaded(replaced(cubeVertices() + cubeFaces(), "f 1 4 3 2", "f 1 4 3 9"));
    EXPECT_EQ(cube.report.triangles, 10U);
    EXPECT_EQ(cube.report.droppedFaces(), 1U);
    ASSERT_EQ(cube.report.warnings.size(), 1U);
    EXPECT_EQ(cube.report.warnings[0].line, 9);
}

TEST(Obj, KeepsTheNormalOfEachCorner)
{
    const LoadedMesh m = loaded("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 1 0 1\nvn 0 1 1\nf 1//1 2//2 3//3\n");
    EXPECT_EQ(m.mesh->normals[0], Vec3d(0, 0, 1));
    EXPECT_EQ(m.mesh->normals[1], normalized(Vec3d(1, 0, 1)));
    EXPECT_EQ(m.mesh->normals[2], normalized(Vec3d(0, 1, 1)));
    EXPECT_EQ(m.report.cornersWithFileNormal, 3U);
}

TEST(Obj, SplitsVerticesOnlyWhereNormalsDiffer)
{
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn 0 .1 1\n";
    EXPECT_EQ(loaded(vertices + "f 1//1 2//1 3//1\nf 2//1 4//1 3//1\n").mesh->positions.size(), 4U);
    const LoadedMesh split = loaded(vertices + "f 1//1 2//1 3//1\nf 2//2 4//2 3//2\n");
    EXPECT_EQ(split.mesh->positions.size(), 6U);
    EXPECT_EQ(split.mesh->fileVertexCount, 4U);
    EXPECT_EQ(split.mesh->fileVertex[1], split.mesh->fileVertex[3]) << "both come from the file's second vertex";
}

TEST(Obj, ADamagedVertexShiftsNoIndex)
{
    const std::string broken =
        "v nan 0 0\nv 1e400 0 0\nv only words\nv 1 2\n" + cubeVertices() + replaced(cubeFaces(), "f ", "f ");
    std::string shifted;
    for (const auto& quad : cubeQuads()) {
        shifted += "f";
        for (const int corner : quad)
            shifted += " " + std::to_string(corner + 5);
        shifted += "\n";
    }
    const LoadedMesh cube = loaded("v nan 0 0\nv 1e400 0 0\nv only words\nv 1 2\n" + cubeVertices() + shifted);
    EXPECT_EQ(cube.report.area, 24.0);
    EXPECT_EQ(cube.report.unusedVertices, 4U);
    EXPECT_EQ(cube.report.warnings.size(), 2U) << "the two lines that hold no three numbers";
    EXPECT_NE(loaded(broken).report.area, 24.0) << "indices into the damaged ones drop faces";
}

TEST(Obj, RepeatedFaultsAreCountedNotListed)
{
    std::string text = cubeVertices() + cubeFaces();
    for (int i = 0; i < 1000; ++i)
        text += "f 1 2 77\n";
    const MeshReport report = loaded(text).report;
    EXPECT_EQ(report.droppedFaces(), 1000U);
    ASSERT_EQ(report.warnings.size(), 4U);
    EXPECT_THAT(report.warnings[3].text, HasSubstr("997 more"));
}

TEST(Obj, TellsOfFlatShadingAndOfMaterials)
{
    std::string flat = "mtllib x.mtl\nvn 0 0 1\nv 0 0 0\n";
    for (int i = 0; i < 102; ++i)
        flat += "v " + std::to_string(i) + " 1 0\n";
    for (int i = 2; i < 103; ++i)
        flat += "f 1//1 " + std::to_string(i + 1) + "//1 " + std::to_string(i) + "//1\n";
    const MeshReport report = loaded(flat).report;
    EXPECT_THAT(report.notes, ::testing::Contains(HasSubstr("materials")));
    EXPECT_THAT(report.notes, ::testing::Contains(HasSubstr("faceted")));
}

} // namespace
} // namespace reflectance::testing
