#include "tests/fuzz/seeds.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace reflectance::fuzz {
namespace {

std::string bytesOf(std::uint32_t value, bool isBig)
{
    std::string bytes(4, '\0');
    for (std::size_t i = 0; i < 4; ++i)
        bytes[isBig ? 3 - i : i] = static_cast<char>(value >> (8 * i));
    return bytes;
}

std::string bytesOf(float value, bool isBig)
{
    return bytesOf(std::bit_cast<std::uint32_t>(value), isBig);
}

/// The corners of a tetrahedron, three numbers each.
constexpr std::array<float, 12> tetrahedron{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
constexpr std::array<std::uint32_t, 12> itsFaces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

std::string binaryPly(bool isBig)
{
    std::string bytes = std::string("ply\nformat binary_") + (isBig ? "big" : "little") +
                        "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                        "element face 4\nproperty list uchar uint vertex_indices\nend_header\n";
    for (const float number : tetrahedron)
        bytes += bytesOf(number, isBig);
    for (std::size_t i = 0; i < itsFaces.size(); ++i)
        bytes += (i % 3 == 0 ? "\x03" : "") + bytesOf(itsFaces[i], isBig);
    return bytes;
}

std::string binaryStl()
{
    std::string bytes = std::string(80, ' ') + bytesOf(4U, false);
    for (std::size_t face = 0; face < 4; ++face) {
        bytes += std::string(12, '\0'); // the normal, which readers compute themselves
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t c = 0; c < 3; ++c)
                bytes += bytesOf(tetrahedron[3 * itsFaces[3 * face + k] + c], false);
        bytes += std::string(2, '\0');
    }
    return bytes;
}

} // namespace

std::vector<std::string> objSeeds()
{
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\n";
    return {corners + "f 1 4 3 2\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n",
            "# an L with normals and texture\r\nmtllib a.mtl\r\no L\r\nv 0 0 0\r\nv 2 0 0\r\nv 2 1 0\r\nv 1 1 0\r\n"
            "v 1 2 0\r\nv 0 2 0\r\nvt 0 0\r\nvn 0 0 1\r\nusemtl clay\r\ns 1\r\n"
            "f 1/1/1 2/1/1 3/1/1 4/1/1 5/1/1 6/1/1\r\n",
            corners + "vn 0 0 1\nf -5//-1 -4//-1 \\\n -3//-1\nf -5 -4 -1\nl 1 2\n",
            "v 1e-300 0 0\nv 9e299 0 0\nv 0 -9e299 1e7\nf 1 2 3"};
}

std::vector<std::string> plySeeds()
{
    return {"ply\nformat ascii 1.0\ncomment small\nelement vertex 4\nproperty double x\nproperty float y\n"
            "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
            "element face 2\nproperty list uchar int vertex_index\nproperty int flags\nend_header\n"
            "0 0 0 0 0 1 255\n1 0 0 0 0 1 255\n1 1 0 0 0 1 255\n0 1 0 0 0 1 255\n3 0 1 2 7\n4 0 1 2 3 7\n",
            binaryPly(false), binaryPly(true)};
}

std::vector<std::string> offSeeds()
{
    return {"OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
            "CNOFF\n# colours and normals\n4 1 0\n0 0 0 0 0 1 1 0 0 1\n1 0 0 0 0 1 1 0 0 1\n1 1 0 0 0 1 1 0 0 1\n"
            "0 1 0 0 0 1 1 0 0 1\n4 0 1 2 3 0.5 0.5 0.5\n"};
}

std::vector<std::string> stlSeeds()
{
    return {
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 1 0 0\nendloop\nendfacet\nendsolid a\n",
        binaryStl()};
}

} // namespace reflectance::fuzz
