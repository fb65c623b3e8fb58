// An OBJ file read in parts by several threads gives what one thread makes of the whole: to the last bit, index, warning
// and line, also where it is damaged.
#include "core/geometry/readers.h"
#include "tests/fuzz/mutations.h"
#include "tests/fuzz/seeds.h"

#include <cstring>
#include <gtest/gtest.h>

namespace reflectance::fuzz {
namespace {

struct Read {
    PolygonSoup soup;
    std::vector<MeshWarning> warnings;
};

Read readInParts(std::string_view text, std::size_t partSize, int threads)
{
    ReadContext context;
    context.file = "a.obj";
    context.threads = threads;
    auto soup = readObj(TextParts(text, partSize), context);
    return {soup ? *std::move(soup) : PolygonSoup(), context.warnings.list()};
}

bool areSame(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3d)) == 0);
}

/// What differs first; empty where nothing does. How faces and normals are held may differ, what they say may not.
std::string difference(const Read& a, const Read& b)
{
    if (!areSame(a.soup.positions, b.soup.positions) || !areSame(a.soup.normals, b.soup.normals))
        return "vertices or normals";
    if (a.soup.corners != b.soup.corners || a.soup.faceCount() != b.soup.faceCount())
        return "corners";
    if (a.soup.namesNormals() != b.soup.namesNormals() || a.soup.notes != b.soup.notes)
        return "normals or notes";
    for (std::size_t i = 0; a.soup.namesNormals() && i < a.soup.corners.size(); ++i)
        if (a.soup.normalAt(i) != b.soup.normalAt(i))
            return "normal of corner " + std::to_string(i);
    for (std::size_t i = 0; i < a.soup.faceCount(); ++i)
        if (a.soup.faceEnd(i) != b.soup.faceEnd(i) || a.soup.lineOf(i) != b.soup.lineOf(i))
            return "face " + std::to_string(i);
    if (a.warnings.size() != b.warnings.size())
        return "number of warnings";
    for (std::size_t i = 0; i < a.warnings.size(); ++i)
        if (a.warnings[i].text != b.warnings[i].text || a.warnings[i].line != b.warnings[i].line)
            return "warning " + a.warnings[i].text;
    return "";
}

/// What a part must not be cut in, or must know of what stood before it.
std::vector<std::string> awkwardTexts()
{
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    return {
        square + "f 1 2 \\\n3\nf 1 \\  \r\n3 4\nf 1 2 3",
        square + "# a path \\\nf 1 2 3\nv 5 5 \\\n\\\n5 # \\\nf 3 4 5\n",
        "v 0 0 0\rv 1 0 0\rv 1 1 0\r\rf 1 2 3\r",
        "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\n\r\nf 1 2 \\\r\n 3\r\n",
        square + "f -1 -2 -3\nv 9 9 9\nf -1 -2 -3\nf -5 -6 1\nf -99999999999999999999 1 2\n",
        square + "f 1 2 3\nf 1 2 3\nvn 0 0 1\nf 1//1 2//1 3//-1\nf 1 2 3 4\nf\nf 1 2 3\n",
        square + "vn 0 0 1\nvn 0 0 1\nvn 0 1 1\nf 1//1 2//2 3//3\nf 2//2 3//3 1//1\nf 1//1 2//2 3//1\nf 1 2 3\n",
        square + "vn 0 0 1\nvn 0 0 1\nvn 0 1 1\nf 1//1 2//2 3//3\nf -3//-3 2//2 1//1\n",
        "q\nq\nz\nq\nq\nv\nf a\nq\nz\nl 1 2\nv 1 2\nusemtl x\nf 1//\n",
        "\n\n  \\\n\\\n\n\tv 1e300 -1e-400 +5\nv 0.1234567890123456789 1.e5 .5\nv 1 2 3 4 5 6\n vn 1 2 3\n",
        "\\\n\\\n\\\n\\\n\\",
    };
}

void expectSameInAnyParts(const std::string& text)
{
    const Read whole = readInParts(text, text.size() + 1, 1);
    for (const std::size_t partSize : {1U, 16U})
        for (const int threads : {1, 3})
            ASSERT_EQ(difference(whole, readInParts(text, partSize, threads)), "")
                << "in parts of " << partSize << " by " << threads << " threads:\n"
                << text;
}

TEST(ObjInParts, AwkwardTextsAreReadAlikeInAnyParts)
{
    for (const std::string& text : awkwardTexts())
        expectSameInAnyParts(text);
}

TEST(ObjInParts, DamagedFilesAreReadAlikeInAnyParts)
{
    std::mt19937_64 random(20261129);
    const std::vector<std::string> seeds = objSeeds();
    for (std::size_t i = 0; i < 1500; ++i)
        expectSameInAnyParts(damaged(seeds[i % seeds.size()], seeds[random() % seeds.size()], random));
}

/// Cut in the middle of a line, or with lines counted wrongly, a file reads differently: the comparison sees it.
TEST(ObjInParts, APlantedWrongCutIsSeen)
{
    const std::string text = awkwardTexts()[0];
    const Read whole = readInParts(text, text.size() + 1, 1);
    EXPECT_NE(difference(whole, readInParts(text.substr(text.find('\\') + 2), 16, 1)), "");
    EXPECT_EQ(difference(whole, readInParts("\n" + text, 16, 1)), "face 0") << "one line later";
}

} // namespace
} // namespace reflectance::fuzz
