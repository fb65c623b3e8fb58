#include "core/study/goniometer/patch.h"

#include "core/base/check.h"

#include <algorithm>

namespace reflectance {
namespace {

struct Mirror {
    bool x = false, y = false;
};

void appendMirrored(Patch& to, const Patch& from, Mirror mirror)
{
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (const Vec3d& p : from.positions)
        to.positions.push_back({mirror.x ? 2.0 * from.width - p.x : p.x, mirror.y ? 2.0 * from.depth - p.y : p.y, p.z});
    const bool turned = mirror.x != mirror.y; // one reflection turns the winding, two do not
    for (const Mesh::Triangle& t : from.triangles)
        to.triangles.push_back({first + t[0], first + t[turned ? 2 : 1], first + t[turned ? 1 : 2]});
}

/// Whether a triangle, moved by (dx, dy), reaches into the patch and its strip.
bool isNear(const Patch& patch, const Mesh::Triangle& t, double dx, double dy, double margin)
{
    const auto& p = patch.positions;
    const auto [x0, x1] = std::minmax({p[t[0]].x, p[t[1]].x, p[t[2]].x});
    const auto [y0, y1] = std::minmax({p[t[0]].y, p[t[1]].y, p[t[2]].y});
    return x1 + dx >= -margin && x0 + dx <= patch.width + margin && y1 + dy >= -margin &&
           y0 + dy <= patch.depth + margin;
}

} // namespace

Patch heightField(std::size_t columns, std::size_t rows, std::span<const double> heights, double width, double depth)
{
    CHECK_EQ(heights.size(), columns * rows);
    Patch patch{width, depth, {}, {}};
    for (std::size_t y = 0; y <= rows; ++y)
        for (std::size_t x = 0; x <= columns; ++x)
            patch.positions.push_back({width * static_cast<double>(x) / static_cast<double>(columns),
                                       depth * static_cast<double>(y) / static_cast<double>(rows),
                                       heights[(y % rows) * columns + x % columns]});
    const auto at = [columns](std::size_t x, std::size_t y) {
        return static_cast<std::uint32_t>(y * (columns + 1) + x);
    };
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x) {
            patch.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            patch.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    return patch;
}

Patch mirroredTile(const Patch& patch)
{
    Patch whole{2.0 * patch.width, 2.0 * patch.depth, {}, {}};
    for (const Mirror mirror : {Mirror{}, Mirror{true, false}, Mirror{false, true}, Mirror{true, true}})
        appendMirrored(whole, patch, mirror);
    const double scale = 1.0 / std::max(whole.width, whole.depth);
    whole.width *= scale;
    whole.depth *= scale;
    for (Vec3d& p : whole.positions)
        p = scale * p;
    return whole;
}

std::shared_ptr<const Mesh> withSurroundings(const Patch& patch, double margin)
{
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = patch.positions;
    mesh->triangles = patch.triangles;
    for (int column = -1; column <= 1; ++column)
        for (int row = -1; row <= 1; ++row) {
            const Vec3d shift{column * patch.width, row * patch.depth, 0.0};
            if (column == 0 && row == 0)
                continue;
            for (const Mesh::Triangle& t : patch.triangles) {
                if (!isNear(patch, t, shift.x, shift.y, margin))
                    continue;
                const auto first = static_cast<std::uint32_t>(mesh->positions.size());
                for (const std::uint32_t corner : t)
                    mesh->positions.push_back(patch.positions[corner] + shift);
                mesh->triangles.push_back({first, first + 1, first + 2});
            }
        }
    return mesh;
}

double rmsSlope(const Patch& patch)
{
    double sum = 0.0;
    double area = 0.0;
    for (const Mesh::Triangle& t : patch.triangles) {
        const Vec3d& a = patch.positions[t[0]];
        const Vec3d n = cross(patch.positions[t[1]] - a, patch.positions[t[2]] - a);
        if (!(n.z > 0.0)) // overhangs have no slope
            continue;
        sum += (n.x * n.x + n.y * n.y) / n.z;
        area += n.z;
    }
    return area > 0.0 ? std::sqrt(sum / area) : 0.0;
}

} // namespace reflectance
