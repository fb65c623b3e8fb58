// Strange files that are right, or right enough: each line of the table says what must come of it. Damaged ones stand in
// damaged_files_test.cpp.
#include "core/base/text.h"
#include "tests/geometry/mesh_text.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace reflectance::testing {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The same file with another writer's line ends.
std::string withLineEnds(const std::string& text, const std::string& lineEnd)
{
    std::string result;
    for (const char c : text)
        result += c == '\n' ? lineEnd : std::string(1, c);
    return result;
}

/// A regular polygon of many corners around the origin.
std::string polygon(int corners)
{
    std::string vertices;
    std::string face = "f";
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        vertices += "v " + shortest(std::cos(angle)) + " " + shortest(std::sin(angle)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    return vertices + face + "\n";
}

struct Strange {
    const char* what;
    const char* name;
    std::string bytes;
    std::size_t triangles;
    std::size_t dropped;
    std::size_t unused;
};

const std::string plyFile = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
                            "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string offFile = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string stlFile = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                            "endloop\nendfacet\nendsolid\n";

std::vector<Strange> oddWritings()
{
    const std::string mark = "\xEF\xBB\xBF";
    std::vector<Strange> files;
    for (const auto& [name, text] :
         {std::pair("a.ply", plyFile), std::pair("a.off", offFile), std::pair("a.stl", stlFile)}) {
        files.push_back({"CRLF", name, withLineEnds(text, "\r\n"), 1, 0, 0});
        files.push_back({"CR", name, withLineEnds(text, "\r"), 1, 0, 0});
        files.push_back({"byte order mark", name, mark + text, 1, 0, 0});
        files.push_back({"no last line end", name, text.substr(0, text.size() - 1), 1, 0, 0});
    }
    return files;
}

std::vector<Strange> strangeFiles()
{
    const std::string good = square + "f 1 2 3\n";
    const std::string tenMegabytes(10'000'000, ' ');
    return {
        {"the same face twice", "a.obj", good + "f 1 2 3\n", 2, 0, 1},
        {"the same face from behind", "a.obj", good + "f 3 2 1\n", 2, 0, 1},
        {"three triangles at one edge", "a.obj", good + "v 0 0 1\nf 1 2 4\nf 1 2 5\n", 3, 0, 0},
        {"two fans that share a vertex", "a.obj", good + "v -1 0 0\nv 0 -1 0\nf 1 5 6\n", 2, 0, 1},
        {"two vertices at one place", "a.obj", good + "v 0 0 0\nf 5 3 4\n", 2, 0, 0},
        {"vertices that no face uses", "a.obj", good + square + square, 1, 0, 9},
        {"a NaN vertex that no face uses", "a.obj", good + "v nan inf -inf\n", 1, 0, 2},
        {"a polygon that touches itself in a vertex", "a.obj", square + "v .5 .5 0\nf 1 2 5 3 4 5\n", 2, 0, 0},
        {"a concave polygon", "a.obj", square + "v .5 .1 0\nf 1 5 2 3 4\n", 3, 0, 0},
        {"a polygon of 100,000 corners", "a.obj", polygon(100'000), 99'998, 0, 0},
        {"a comment of 10 MB", "a.obj", "#" + tenMegabytes + "\n" + good, 1, 0, 1},
        {"a face with 10 MB of blanks in it", "a.obj", square + "f 1 " + tenMegabytes + "2 3\n", 1, 0, 1},
        {"a number of 10 million digits", "a.obj",
         "v 0." + std::string(10'000'000, '0') + " 0 0\n" + "v 1 0 0\nv 0 1 0\nf 1 2 3\n", 1, 0, 0},
        {"an unknown word of 10 MB", "a.obj", std::string(10'000'000, 'x') + "\n" + good, 1, 0, 1},
        {"10 MB without a line end", "a.obj", good + "vt" + tenMegabytes, 1, 0, 1},
        {"material files that are not there", "a.obj",
         "mtllib missing.mtl\nmtllib /etc/missing.mtl\nmtllib ../../../missing.mtl\nmtllib\n" + good, 1, 0, 1},
    };
}

void expectRead(const Strange& file)
{
    const LoadedMesh mesh = loaded(file.bytes, file.name);
    EXPECT_EQ(mesh.report.triangles, file.triangles) << file.what;
    EXPECT_EQ(mesh.report.droppedFaces(), file.dropped) << file.what;
    EXPECT_EQ(mesh.report.unusedVertices, file.unused) << file.what;
    for (const MeshWarning& warning : mesh.report.warnings)
        EXPECT_LT(warning.text.size(), 200U) << file.what << ": a warning is a sentence, not the file";
}

TEST(Corpus, EveryWriterIsUnderstood)
{
    for (const Strange& file : oddWritings()) {
        SCOPED_TRACE(file.name);
        expectRead(file);
    }
}

TEST(Corpus, NothingIsLostOfStrangeFiles)
{
    for (const Strange& file : strangeFiles())
        expectRead(file);
}

TEST(Corpus, APlantedLossIsNoticed)
{
    const LoadedMesh mesh = loaded(square + "f 1 2 3\n" + "f 1 2 9\n");
    EXPECT_NE(mesh.report.triangles, 2U);
    EXPECT_NE(mesh.report.droppedFaces(), 0U);
}

/// In both byte orders.
TEST(Corpus, Utf16IsNamed)
{
    for (const auto& [name, text] :
         {std::pair("a.ply", plyFile), std::pair("a.off", offFile), std::pair("a.stl", stlFile)}) {
        std::string little = "\xFF\xFE";
        std::string big = "\xFE\xFF";
        for (const char c : text) {
            little += {c, '\0'};
            big += {'\0', c};
        }
        EXPECT_THAT(refusal(little, name), ::testing::HasSubstr("UTF-16"));
        EXPECT_THAT(refusal(big, name), ::testing::HasSubstr("UTF-16"));
    }
}

} // namespace
} // namespace reflectance::testing
