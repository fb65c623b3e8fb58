// Files that crash or hang common readers. Each line of the table says what must come of it.
#include "tests/geometry/mesh_text.h"

#include <gmock/gmock.h>

namespace reflectance::testing {
namespace {

using ::testing::HasSubstr;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string plyHead = "ply\nformat ascii 1.0\n";
const std::string plyVertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string plyFace = "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
const std::string offTriangle = "0 0 0\n1 0 0\n0 1 0\n";

struct Survived {
    const char* what;
    const char* name;
    std::string bytes;
    std::size_t triangles;
    std::size_t dropped;
    std::size_t degenerate;
};

std::vector<Survived> survivedFiles()
{
    const std::string good = square + "f 1 2 3\n";
    return {
        {"index past the end with a normal", "a.obj", good + "vn 0 0 1\nf 1//1 2//1 9//1\n", 1, 1, 0},
        {"index 0", "a.obj", good + "f 0 1 2\n", 1, 1, 0},
        {"index too negative", "a.obj", good + "f -1 -2 -9\n", 1, 1, 0},
        {"index beyond 64 bits", "a.obj", good + "f 1 2 99999999999999999999999\n", 1, 1, 0},
        {"empty vertex place", "a.obj", good + "f /1/1 2/1/1 3/1/1\n", 1, 1, 0},
        {"normal index past the end", "a.obj", square + "vn 0 0 1\nf 1//1 2//7 3//-9\n", 1, 0, 0},
        {"faces of 0, 1 and 2 corners", "a.obj", good + "f\nf 1\nf 1 2\n", 1, 3, 0},
        {"a corner twice in a row", "a.obj", good + "f 1 2 2 3\nf 1 1 2\n", 2, 1, 0},
        {"a triangle on a line", "a.obj", good + "v 2 0 0\nf 1 2 5\n", 1, 0, 1},
        {"words instead of indices", "a.obj", good + "f one two three\n", 1, 1, 0},
        {"a NaN vertex in one face", "a.obj", good + "v nan nan nan\nf 1 2 5\n", 1, 1, 0},
        {"an infinite vertex in one face", "a.obj", good + "v inf 0 0\nf 1 2 5\n", 1, 1, 0},
        {"lines, points and free-form curves", "a.obj", good + "l 1 2\np 3\ncurv 0 1 2\n", 1, 0, 0},
        {"binary junk at the end", "a.obj", good + std::string(5000, '#') + std::string("\n\0\x01\xFF\xFE", 5), 1, 0,
         0},
        {"ply: more vertices announced than there are", "a.ply",
         plyHead +
             "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
             "1000000000000000000\n" +
             plyFace + "3 0 1 2\n",
         1, 0, 0},
        {"ply: a negative list count", "a.ply",
         plyHead + plyVertex + "element face 2\n" + plyFace + "-3 0 1 2\n3 0 1 2\n", 1, 1, 0},
        {"ply: a list of a thousand million", "a.ply",
         plyHead + plyVertex + "element face 2\n" + plyFace + "1000000000 0 1 2\n3 0 1 2\n", 1, 1, 0},
        {"ply: an element without properties", "a.ply",
         plyHead + "element nothing 1000000000000000000\n" + plyVertex + "element face 1\n" + plyFace + "3 0 1 2\n", 1,
         0, 0},
        {"ply: indices that are no indices", "a.ply",
         plyHead + plyVertex + "element face 3\n" + plyFace + "3 0 1 nan\n3 0 1 -7\n3 0 1 2\n", 1, 2, 0},
        {"off: a face of -4 and one of a thousand million corners", "a.off",
         "OFF\n3 3 0\n" + offTriangle + "-4 0 1 2\n1000000000 0 1 2\n3 0 1 2\n", 1, 2, 0},
        {"off: more faces announced than there are", "a.off", "OFF\n3 4000000000 0\n" + offTriangle + "3 0 1 2\n", 1, 0,
         0},
        {"coff: a bad face with a colour", "a.off",
         "COFF\n3 2 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 9 255 0 0\n3 0 1 2 255 0 0\n", 1, 1, 0},
        {"stl: text cut within a facet", "a.stl",
         "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nfacet\nouter "
         "loop\nvertex 1",
         1, 1, 0},
    };
}

TEST(DamagedFiles, WhatCanBeSavedIsSavedAndTheRestCounted)
{
    for (const Survived& file : survivedFiles()) {
        const LoadedMesh mesh = loaded(file.bytes, file.name);
        EXPECT_EQ(mesh.report.triangles, file.triangles) << file.what;
        EXPECT_EQ(mesh.report.droppedFaces(), file.dropped) << file.what;
        EXPECT_EQ(mesh.report.degenerateTriangles, file.degenerate) << file.what;
        for (const Vec3d& normal : mesh.mesh->normals)
            EXPECT_NEAR(length(normal), 1.0, 1e-15) << file.what; // three roundings of a unit vector
    }
}

struct Refused {
    const char* what;
    const char* name;
    std::string bytes;
    const char* sentence;
};

std::vector<Refused> refusedFiles()
{
    const std::string nul(1, '\0');
    return {
        {"nothing", "a.obj", "", "a.obj: is empty"},
        {"only a byte order mark", "a.obj", "\xEF\xBB\xBF", "is empty"},
        {"only comments", "a.obj", "# nothing here\n", "lists 0 vertices and no faces"},
        {"only points", "a.obj", square, "lists 4 vertices and no faces"},
        {"faces without vertices", "a.obj", "f 1 2 3\n", "a face uses a vertex that the file does not have (1 time)"},
        {"only a degenerate triangle", "a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "1 triangle without area"},
        {"UTF-16", "a.obj", "\xFF\xFEv" + nul + " " + nul, "UTF-16"},
        {"a compressed file", "a.obj", "\x1F\x8B\x08", "unpack it first"},
        {"a picture", "a.obj", "\x89PNG\r\n\x1A\n" + nul + nul, "not a mesh of a known format"},
        {"a web page", "page", "<html><body>404</body></html>", "not a mesh of a known format"},
        {"ply without format", "a.ply", "ply\nelement vertex 3\nend_header\n",
         "a.ply:3: the PLY header has no format line"},
        {"ply with an unknown format", "a.ply", "ply\nformat utf8 1.0\nend_header\n", "a.ply:2: the format is none of"},
        {"ply without end_header", "a.ply", plyHead + plyVertex, "does not end"},
        {"ply: property before any element", "a.ply", plyHead + "elemnt vertex 3\n",
         "\"elemnt\" is not a PLY header line"},
        {"ply: property first", "a.ply", plyHead + "property float x\n", "stands before the first element"},
        {"ply: a count that is a word", "a.ply", plyHead + "element vertex many\n",
         "a.ply:3: the number of elements \"vertex\""},
        {"ply: a negative count", "a.ply", plyHead + "element vertex -5\n", "is not a count"},
        {"ply: an unknown type, unprintable", "a.ply", plyHead + "element vertex 1\nproperty fl\x01\x02 x\n",
         "\"fl?\?\" is not known"},
        {"stl too short", "a.stl", "tiny" + nul, "too short for an STL"},
        {"stl with nothing in it", "a.stl", "solid empty\nendsolid\n", "lists 0 vertices and no faces"},
    };
}

TEST(DamagedFiles, ARefusalSaysWhatAndWhere)
{
    for (const Refused& file : refusedFiles())
        EXPECT_THAT(refusal(file.bytes, file.name), HasSubstr(file.sentence)) << file.what;
}

TEST(DamagedFiles, APlantedGoodFileIsNotRefused)
{
    EXPECT_EQ(refusal(square + "f 1 2 3 4\n"), "");
}

/// Every prefix of a good file, and the file with each of its bytes changed in turn: never a crash, never a bad mesh.
TEST(DamagedFiles, NoCutAndNoChangedByteDoesHarm)
{
    const std::string obj = square + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf -4 -3 -2\n";
    const std::string ply = plyHead + plyVertex + "element face 1\n" + plyFace + "3 0 1 2\n";
    const std::string off = "OFF\n3 1 0\n" + offTriangle + "3 0 1 2\n";
    std::string bigPly = "ply\nformat binary_big_endian 1.0\n" + plyVertex +
                         "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    bigPly += std::string(36, '\x3F') + "\x03" + std::string("\0\0\0\0\0\0\0\1\0\0\0\2", 12);
    const auto check = [](const std::string& bytes, const char* name) {
        const auto mesh = readMesh(bytes, name);
        if (!mesh) {
            EXPECT_FALSE(mesh.error().message.empty()) << name;
            return;
        }
        for (const Mesh::Triangle& t : mesh.value().mesh->triangles)
            for (const std::uint32_t v : t)
                ASSERT_LT(v, mesh.value().mesh->positions.size());
        for (const Vec3d& p : mesh.value().mesh->positions)
            ASSERT_LE(length(p), 1.0 + 1e-12) << name; // the farthest point is 1 up to rounding
    };
    for (const auto& [bytes, name] :
         {std::pair(obj, "a.obj"), std::pair(ply, "a.ply"), std::pair(off, "a.off"), std::pair(bigPly, "b.ply")})
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            check(bytes.substr(0, i), name);
            for (const char c : {'\0', '\n', '-', '9', '\xFF'}) {
                std::string changed = bytes;
                changed[i] = c;
                check(changed, name);
            }
        }
}

} // namespace
} // namespace reflectance::testing
