// PLY in its three encodings, with scalar types and elements in any order.
#include "tests/geometry/mesh_text.h"

#include <bit>
#include <cstring>
#include <gmock/gmock.h>
#include <span>

namespace reflectance::testing {
namespace {

using ::testing::HasSubstr;

template <class Number> void append(std::string& bytes, Number value, bool big)
{
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    if (big != (std::endian::native == std::endian::big))
        raw.assign(raw.rbegin(), raw.rend());
    bytes += raw;
}

std::string header(const std::string& format, const std::string& coordinate, const std::string& index)
{
    return "ply\nformat " + format + " 1.0\ncomment a cube\nelement vertex 8\nproperty " + coordinate +
           " x\nproperty " + coordinate + " y\nproperty " + coordinate + " z\nelement face 6\nproperty list uchar " +
           index + " vertex_indices\nend_header\n";
}

template <class Coordinate, class Index> std::string binaryCube(const std::string& head, bool big)
{
    std::string bytes = head;
    for (const Vec3d& p : cubeCorners())
        for (const double component : {p.x, p.y, p.z})
            append(bytes, static_cast<Coordinate>(component), big);
    for (const auto& quad : cubeQuads()) {
        append(bytes, std::uint8_t{4}, big);
        for (const int corner : quad)
            append(bytes, static_cast<Index>(corner), big);
    }
    return bytes;
}

std::string asciiCube(const std::string& faceExtra = "")
{
    std::string text = header("ascii", "float", "int");
    for (const Vec3d& p : cubeCorners())
        text += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    for (const auto& quad : cubeQuads())
        text += "4 " + std::to_string(quad[0]) + " " + std::to_string(quad[1]) + " " + std::to_string(quad[2]) + " " +
                std::to_string(quad[3]) + faceExtra + "\n";
    return text;
}

void expectCube(const std::string& bytes, const std::string& what)
{
    const LoadedMesh cube = loaded(bytes, "cube.ply");
    EXPECT_EQ(cube.report.triangles, 12U) << what;
    EXPECT_EQ(cube.report.area, 24.0) << what;
    EXPECT_TRUE(cube.report.warnings.empty()) << what;
}

TEST(Ply, ReadsEveryEncodingAndType)
{
    expectCube(asciiCube(), "ascii");
    expectCube(binaryCube<float, std::int32_t>(header("binary_little_endian", "float", "int"), false), "little-endian");
    expectCube(binaryCube<float, std::int32_t>(header("binary_big_endian", "float", "int"), true), "big-endian");
    expectCube(binaryCube<double, std::uint32_t>(header("binary_little_endian", "double", "uint"), false),
               "double and uint");
    expectCube(binaryCube<std::int16_t, std::uint8_t>(header("binary_big_endian", "short", "uchar"), true),
               "short and uchar");
    expectCube(binaryCube<std::int8_t, std::uint16_t>(header("binary_little_endian", "int8", "uint16"), false),
               "int8 and uint16");
}

TEST(Ply, APlantedWrongByteOrderIsNoticed)
{
    const std::string wrong = binaryCube<float, std::int32_t>(header("binary_big_endian", "float", "int"), false);
    EXPECT_THAT(refusal(wrong, "cube.ply"), HasSubstr("has no usable faces"));
}

TEST(Ply, StepsOverWhatItDoesNotKnow)
{
    const std::string text =
        "ply\r\nformat ascii 1.0\r\nelement material 1\r\nproperty list uchar float values\r\nproperty int id\r\n"
        "element vertex 3\r\nproperty uchar red\r\nproperty float y\r\nproperty float x\r\nproperty float z\r\n"
        "element face 1\r\nproperty list uchar uchar texture\r\nproperty list uchar int vertex_index\r\n"
        "end_header\r\n2 0.5 0.5 7\r\n255 0 0 0\r\n255 0 2 0\r\n255 2 0 0\r\n1 9 3 0 1 2\r\n";
    EXPECT_EQ(loaded(text, "a.ply").report.area, 2.0);
}

TEST(Ply, ReadsNormalsOfVertices)
{
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0 0 0 3\n1 0 0 0 0 3\n0 1 0 0 0 3\n3 0 1 2\n";
    const LoadedMesh m = loaded(text, "a.ply");
    EXPECT_EQ(m.report.cornersWithFileNormal, 3U);
    EXPECT_EQ(m.mesh->normals[2], Vec3d(0, 0, 1));
}

TEST(Ply, KeepsWhatACutFileStillHolds)
{
    const std::string whole = binaryCube<float, std::int32_t>(header("binary_little_endian", "float", "int"), false);
    const LoadedMesh cut = loaded(whole.substr(0, whole.size() - 20), "cube.ply");
    EXPECT_EQ(cut.report.droppedFaces(), 1U);
    EXPECT_EQ(cut.report.triangles, 8U);
    ASSERT_EQ(cut.report.warnings.size(), 3U);
    EXPECT_THAT(cut.report.warnings[1].text, HasSubstr("ends before"));
}

/// The sphere as binary PLY. Plain, it is read at once; with a list of no use in every face no quick way takes it.
std::string binarySphere(bool isPlain, const std::string& type, bool hasNormals, bool endsInQuad = false)
{
    const std::shared_ptr<const Mesh> sphere = loaded(sphereObj(20, 40)).mesh;
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                        std::to_string(sphere->positions.size()) + "\nproperty uchar red\n";
    for (const std::string name : {"x", "y", "z", "nx", "ny", "nz"})
        bytes += hasNormals || name.size() == 1 ? "property " + type + " " + name + "\n" : "";
    bytes += "element face " + std::to_string(sphere->triangles.size() + (endsInQuad ? 1 : 0)) +
             "\nproperty list uchar int vertex_indices\n" + (isPlain ? "" : "property list uchar uchar unused\n") +
             "end_header\n";
    const auto appendVector = [&](const Vec3d& v) {
        for (const double component : {v.x, v.y, v.z})
            type == "double" ? append(bytes, component, false) : append(bytes, static_cast<float>(component), false);
    };
    const auto appendFace = [&](std::span<const std::uint32_t> face) {
        append(bytes, static_cast<std::uint8_t>(face.size()), false);
        for (const std::uint32_t v : face)
            append(bytes, static_cast<std::int32_t>(v), false);
        bytes += isPlain ? "" : std::string("\x02zz");
    };
    for (std::size_t i = 0; i < sphere->positions.size(); ++i) {
        bytes += '\x09';
        appendVector(sphere->positions[i]);
        if (hasNormals)
            appendVector(sphere->normals[i]);
    }
    for (const Mesh::Triangle& triangle : sphere->triangles)
        appendFace(triangle);
    if (endsInQuad)
        appendFace(std::array<std::uint32_t, 4>{0, 50, 300, 200});
    return bytes;
}

TEST(Ply, TheQuickWayGivesWhatTheLongOneGives)
{
    for (const char* type : {"float", "double"})
        for (const bool hasNormals : {false, true})
            for (const bool endsInQuad : {false, true}) {
                const LoadedMesh quick = loaded(binarySphere(true, type, hasNormals, endsInQuad), "s.ply");
                const LoadedMesh slow = loaded(binarySphere(false, type, hasNormals, endsInQuad), "s.ply");
                EXPECT_EQ(quick.mesh->positions, slow.mesh->positions) << type;
                EXPECT_EQ(quick.mesh->normals, slow.mesh->normals) << type;
                EXPECT_EQ(quick.mesh->triangles, slow.mesh->triangles) << type;
                EXPECT_EQ(quick.report.cornersWithFileNormal > 0, hasNormals);
                EXPECT_TRUE(quick.report.warnings.empty() && slow.report.warnings.empty());
                EXPECT_EQ(quick.report.fileFaces, slow.report.fileFaces);
            }
}

TEST(Ply, AFaceThatNamesNoVertexIsDroppedByEitherWay)
{
    for (const bool isPlain : {true, false}) {
        std::string bytes = binarySphere(isPlain, "float", false);
        const std::size_t lastIndex = bytes.size() - 4 - (isPlain ? 0 : 3);
        std::memset(bytes.data() + lastIndex, 0xff, 4); // -1
        EXPECT_EQ(loaded(bytes, "s.ply").report.droppedFaces(), 1U) << isPlain;
    }
}

} // namespace
} // namespace reflectance::testing
