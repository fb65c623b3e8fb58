#include "tests/geometry/mesh_text.h"

#include "core/base/text.h"

#include <gtest/gtest.h>
#include <numbers>

namespace reflectance::testing {

const std::vector<Vec3d>& cubeCorners()
{
    static const std::vector<Vec3d> corners{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                            {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    return corners;
}

const std::vector<std::vector<int>>& cubeQuads()
{
    static const std::vector<std::vector<int>> quads{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                     {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}};
    return quads;
}

std::string cubeVertices()
{
    std::string text;
    for (const Vec3d& p : cubeCorners())
        text += "v " + shortest(p.x) + " " + shortest(p.y) + " " + shortest(p.z) + "\n";
    return text;
}

std::string cubeFaces()
{
    std::string text;
    for (const auto& quad : cubeQuads()) {
        text += "f";
        for (const int corner : quad)
            text += " " + std::to_string(corner + 1);
        text += "\n";
    }
    return text;
}

std::string sphereObj(int rows, int columns, double scale, const Vec3d& offset)
{
    std::string text;
    const auto add = [&](const Vec3d& p) {
        const Vec3d q = scale * p + offset;
        text += "v " + shortest(q.x) + " " + shortest(q.y) + " " + shortest(q.z) + "\n";
    };
    add({0, 1, 0});
    for (int row = 1; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double latitude = std::numbers::pi * row / rows;
            const double longitude = 2.0 * std::numbers::pi * column / columns;
            add({std::sin(latitude) * std::cos(longitude), std::cos(latitude),
                 -std::sin(latitude) * std::sin(longitude)});
        }
    add({0, -1, 0});
    const int last = (rows - 1) * columns + 2;
    const auto id = [&](int row, int column) {
        return row == 0 ? 1 : (row == rows ? last : 2 + (row - 1) * columns + column % columns);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            text += "f " + std::to_string(id(row, column)) + " " + std::to_string(id(row + 1, column));
            if (row + 1 < rows)
                text += " " + std::to_string(id(row + 1, column + 1));
            if (row > 0)
                text += " " + std::to_string(id(row, column + 1));
            text += "\n";
        }
    return text;
}

LoadedMesh loaded(const std::string& bytes, const std::string& name, const LoadOptions& options)
{
    auto mesh = readMesh(bytes, name, options);
    if (mesh)
        return *std::move(mesh);
    ADD_FAILURE() << mesh.error().sentence();
    return {std::make_shared<Mesh>(), {}};
}

std::string refusal(const std::string& bytes, const std::string& name)
{
    const auto mesh = readMesh(bytes, name);
    return mesh ? std::string() : mesh.error().sentence();
}

double drawnArea(const Mesh& mesh)
{
    double area = 0.0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Vec3d& a = mesh.positions[t[0]];
        area += 0.5 * length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
    }
    return area;
}

} // namespace reflectance::testing
