#include "core/study/bench/ball.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

void append(std::string& text, double number)
{
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::fixed, 6).ptr;
    text.append(" ").append(digits, end);
}

void appendRow(std::string& text, const char* key, const Vec3d& v)
{
    text += key;
    append(text, v.x);
    append(text, v.y);
    append(text, v.z);
    text += '\n';
}

template <class T> void appendBytes(std::string& bytes, T value)
{
    static_assert(std::endian::native == std::endian::little);
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes.append(raw.data(), raw.size());
}

} // namespace

std::shared_ptr<const Mesh> ball(std::size_t triangles)
{
    const auto rings = static_cast<std::uint32_t>(std::max(2.0, std::sqrt(static_cast<double>(triangles) / 4.0)));
    const std::uint32_t around = 2 * rings;
    auto mesh = std::make_shared<Mesh>();
    mesh->name = "ball";
    for (std::uint32_t i = 0; i <= rings; ++i)
        for (std::uint32_t j = 0; j <= around; ++j) {
            const double polar = std::numbers::pi * i / rings;
            const double azimuth = 2.0 * std::numbers::pi * j / around;
            mesh->positions.emplace_back(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                         -std::sin(polar) * std::sin(azimuth));
        }
    mesh->normals = mesh->positions; // a sphere's own
    const auto vertex = [around](std::uint32_t i, std::uint32_t j) { return i * (around + 1) + j; };
    for (std::uint32_t i = 0; i < rings; ++i)
        for (std::uint32_t j = 0; j < around; ++j) {
            if (i > 0)
                mesh->triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
            if (i + 1 < rings)
                mesh->triangles.push_back({vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)});
        }
    return mesh;
}

std::string objOf(const Mesh& mesh)
{
    std::string text;
    for (const Vec3d& p : mesh.positions)
        appendRow(text, "v", p);
    for (const Vec3d& n : mesh.normals)
        appendRow(text, "vn", n);
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        text += 'f';
        for (const std::uint32_t corner : triangle) {
            const std::string number = std::to_string(corner + 1);
            text.append(" ").append(number).append("//").append(number);
        }
        text += '\n';
    }
    return text;
}

std::string plyOf(const Mesh& mesh)
{
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.positions.size());
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        bytes += std::string("\nproperty float ") + name;
    bytes += "\nelement face " + std::to_string(mesh.triangles.size()) +
             "\nproperty list uchar uint vertex_indices\nend_header\n";
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        for (const Vec3d& v : {mesh.positions[i], mesh.normals[i]})
            for (const double component : {v.x, v.y, v.z})
                appendBytes(bytes, static_cast<float>(component));
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        bytes += '\3';
        for (const std::uint32_t corner : triangle)
            appendBytes(bytes, corner);
    }
    return bytes;
}

} // namespace reflectance
