// Reading takes memory in proportion to the file, whatever it announces: the greediest files of every format, and every
// allocation counted.
#include "core/geometry/load.h"
#include "tests/fuzz/counted_memory.h"

#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace reflectance::fuzz {
namespace {

/// The most memory that a mesh file may take while it is read, in sizes of the file: 68 is the most seen here, and a
/// vector that has just grown can double that.
constexpr std::size_t mostOfMesh = 160;

std::string repeated(std::string_view text, std::size_t bytes)
{
    std::string result;
    while (result.size() < bytes)
        result += text;
    return result;
}

/// Faces of three corners among 200, no two alike: each triangle gets normals of its own.
std::string randomFaces(std::size_t bytes)
{
    std::mt19937_64 random(1);
    std::string result;
    while (result.size() < bytes) {
        result += '\3';
        for (int corner = 0; corner < 3; ++corner)
            result += static_cast<char>(random() % 200);
    }
    return result;
}

std::string randomCorners()
{
    std::mt19937_64 random(2);
    std::string result(600, '\0');
    for (char& c : result)
        c = static_cast<char>(random());
    return result;
}

std::string plyWith(const std::string& vertex, const std::string& face, const std::string& body)
{
    return "ply\nformat binary_little_endian 1.0\nelement vertex " + vertex + "\nelement face " + face +
           "\nproperty list uchar uchar vertex_index\nend_header\n" + body;
}

/// Bytes at the peak of reading, over those of the file.
double greedOf(const std::string& bytes, const std::string& name)
{
    const std::size_t before = restartPeak();
    (void)readMesh(bytes, name);
    return static_cast<double>(peakMemory() - before) / static_cast<double>(bytes.size());
}

struct Greedy {
    const char* what;
    const char* name;
    std::string bytes;
};

std::vector<Greedy> greedyFiles()
{
    constexpr std::size_t size = 1'000'000;
    const std::string xyz = "\nproperty uchar x\nproperty uchar y\nproperty uchar z";
    const std::string corners("\0\0\0\1\0\0\0\1\0", 9);
    return {
        {"vertices", "a.obj", repeated("v 1 1 1\n", size)},
        {"vertices without numbers", "a.obj", repeated("v\n", size)},
        {"triangles", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + repeated("f 1 2 3\n", size)},
        {"faces without corners", "a.obj", repeated("f\n", size)},
        {"corners", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf" + repeated(" 1 2 3", size)},
        {"unknown words", "a.obj", repeated("q\n", size)},
        {"vertices of a byte", "a.ply", plyWith("1000000\nproperty uchar nz", "0", std::string(size, '\1'))},
        {"faces of a byte", "a.ply", plyWith("3" + xyz, "1000000", corners + std::string(size, '\0'))},
        {"triangles of four bytes", "a.ply",
         plyWith("3" + xyz, "250000", corners + repeated(std::string_view("\3\0\1\2", 4), size))},
        {"triangles that all differ", "a.ply", plyWith("200" + xyz, "250000", randomCorners() + randomFaces(size))},
        {"counts without contents", "a.ply", plyWith("4000000000" + xyz, "4000000000", std::string(size, '\7'))},
        {"faces", "a.off", "OFF\n3 1000000000 0\n0 0 0\n1 0 0\n0 1 0\n" + repeated("3 0 1 2\n", size)},
        {"triangles", "a.stl", "solid\n" + repeated("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n", size)},
        {"points", "a.stl", "facet\n" + repeated("vertex\n", size)},
    };
}

TEST(Memory, IsBoundedByTheSizeOfTheMeshFile)
{
    for (const Greedy& file : greedyFiles()) {
        const double greed = greedOf(file.bytes, file.name);
        std::cout << file.name << ", " << file.what << ": " << greed << '\n';
        EXPECT_LT(greed, static_cast<double>(mostOfMesh)) << file.name << ": " << file.what;
    }
}

TEST(Memory, APlantedGreedIsCounted)
{
    const std::size_t before = restartPeak();
    {
        const std::vector<char> block(10'000'000);
        EXPECT_GE(peakMemory() - before, block.size());
    }
    EXPECT_LT(restartPeak() - before, 1'000'000U) << "and given back";
}

} // namespace
} // namespace reflectance::fuzz
