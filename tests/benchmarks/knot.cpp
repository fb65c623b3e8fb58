#include "tests/benchmarks/knot.h"

#include "core/base/file.h"
#include "core/geometry/load.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <numbers>

namespace reflectance::bench {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// The (2,3) torus knot, t in 0 .. 1.
Vec3d knotCurve(double t)
{
    const double r = 2.0 + std::cos(3.0 * turn * t);
    return {r * std::cos(2.0 * turn * t), r * std::sin(2.0 * turn * t), std::sin(3.0 * turn * t)};
}

/// The tube about the curve, u along and v around it, both 0 .. 1.
Vec3d tube(double u, double v)
{
    constexpr double step = 1e-4;
    const Vec3d along = normalized(knotCurve(u + step) - knotCurve(u - step));
    const Vec3d side = normalized(cross(along, Vec3d{0.0, 0.0, 1.0}));
    const Vec3d up = cross(side, along);
    const double radius = 0.45 * (1.0 + 0.06 * std::sin(40.0 * turn * u) * std::cos(5.0 * turn * v));
    return knotCurve(u) + radius * (std::cos(turn * v) * side + std::sin(turn * v) * up);
}

/// Rings of `around` vertices each, ten times as many rings.
struct Grid {
    std::int64_t around, along;

    explicit Grid(std::int64_t triangles)
        : around(std::max<std::int64_t>(3, std::llround(std::sqrt(static_cast<double>(triangles) / 20.0)))),
          along(std::max<std::int64_t>(3, triangles / (2 * around)))
    {
    }

    [[nodiscard]] Vec3d position(std::int64_t i, std::int64_t j) const
    {
        return tube(static_cast<double>(i) / static_cast<double>(along),
                    static_cast<double>(j) / static_cast<double>(around));
    }
    [[nodiscard]] Vec3d normal(std::int64_t i, std::int64_t j) const
    {
        constexpr double step = 1e-5;
        const double u = static_cast<double>(i) / static_cast<double>(along);
        const double v = static_cast<double>(j) / static_cast<double>(around);
        return normalized(cross(tube(u, v + step) - tube(u, v - step), tube(u + step, v) - tube(u - step, v)));
    }
    [[nodiscard]] std::int64_t index(std::int64_t i, std::int64_t j) const { return i % along * around + j % around; }

    template <class Visit> void eachVertex(const Visit& visit) const
    {
        for (std::int64_t i = 0; i < along; ++i)
            for (std::int64_t j = 0; j < around; ++j)
                visit(i, j);
    }
    template <class Visit> void eachTriangle(const Visit& visit) const
    {
        eachVertex([&](std::int64_t i, std::int64_t j) {
            visit(index(i, j), index(i, j + 1), index(i + 1, j));
            visit(index(i + 1, j), index(i, j + 1), index(i + 1, j + 1));
        });
    }
};

template <class... Numbers> void addLine(std::string& text, const char* format, Numbers... numbers)
{
    char line[160];
    text.append(line, static_cast<std::size_t>(std::snprintf(line, sizeof line, format, numbers...)));
}

template <class Number> void addBytes(std::string& bytes, Number number)
{
    char raw[sizeof(Number)];
    std::memcpy(raw, &number, sizeof raw);
    bytes.append(raw, sizeof raw);
}

} // namespace

std::string knotObj(std::int64_t triangles, KnotNormals normals)
{
    const Grid grid(triangles);
    std::string text;
    grid.eachVertex([&](std::int64_t i, std::int64_t j) {
        const Vec3d p = grid.position(i, j);
        addLine(text, "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
    });
    if (normals == KnotNormals::InFile)
        grid.eachVertex([&](std::int64_t i, std::int64_t j) {
            const Vec3d n = grid.normal(i, j);
            addLine(text, "vn %.6f %.6f %.6f\n", n.x, n.y, n.z);
        });
    grid.eachTriangle([&](std::int64_t a, std::int64_t b, std::int64_t c) {
        const auto A = static_cast<long long>(a + 1);
        const auto B = static_cast<long long>(b + 1);
        const auto C = static_cast<long long>(c + 1);
        if (normals == KnotNormals::InFile)
            addLine(text, "f %lld//%lld %lld//%lld %lld//%lld\n", A, A, B, B, C, C);
        else
            addLine(text, "f %lld %lld %lld\n", A, B, C);
    });
    return text;
}

std::string knotPly(std::int64_t triangles)
{
    const Grid grid(triangles);
    const std::int64_t vertices = grid.around * grid.along;
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices) +
                        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                        std::to_string(2 * vertices) + "\nproperty list uchar int vertex_indices\nend_header\n";
    grid.eachVertex([&](std::int64_t i, std::int64_t j) {
        const Vec3f p(grid.position(i, j));
        for (const float coordinate : {p.x, p.y, p.z})
            addBytes(bytes, coordinate);
    });
    grid.eachTriangle([&](std::int64_t a, std::int64_t b, std::int64_t c) {
        bytes += '\3';
        for (const std::int64_t corner : {a, b, c})
            addBytes(bytes, static_cast<std::int32_t>(corner));
    });
    return bytes;
}

std::string knotFile(std::int64_t triangles, KnotNormals normals)
{
    const std::string name =
        "reflectance_knot_" + std::to_string(triangles) + (normals == KnotNormals::InFile ? "_normals.obj" : ".obj");
    const std::string path = (std::filesystem::temp_directory_path() / name).string();
    if (!std::filesystem::exists(path))
        if (const auto written = writeAtomically(path, knotObj(triangles, normals)); !written) {
            std::cerr << written.error().sentence() << '\n';
            std::exit(2);
        }
    return path;
}

std::shared_ptr<const Mesh> knotMesh(std::int64_t triangles)
{
    const auto loaded = loadMesh(knotFile(triangles, KnotNormals::InFile));
    if (!loaded) {
        std::cerr << loaded.error().sentence() << '\n';
        std::exit(2);
    }
    return loaded->mesh;
}

} // namespace reflectance::bench
