#include "tools/meshes/shape.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>

namespace reflectance::stock {
namespace {

using Index = std::uint32_t;

bool isOnePoint(const SurfacePoint* row, int columns)
{
    return std::all_of(row, row + columns,
                       [row](const SurfacePoint& p) { return length(p.position - row->position) < 1e-9; });
}

/// Adds the face, corners that repeat left out, wound to agree with the normals.
void addFace(Shape& shape, std::array<Index, 4> quad)
{
    std::vector<Index> face;
    for (const Index corner : quad)
        if (std::find(face.begin(), face.end(), corner) == face.end())
            face.push_back(corner);
    Vec3d area;
    Vec3d normal;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const SurfacePoint& p = shape.points[face[i]];
        area += cross(p.position, shape.points[face[(i + 1) % face.size()]].position);
        normal += p.normal;
    }
    if (dot(area, normal) < 0.0)
        std::reverse(face.begin(), face.end());
    shape.faces.push_back(std::move(face));
}

void appendNumber(std::string& text, double value, int decimals)
{
    char buffer[32];
    const int size = std::snprintf(buffer, sizeof buffer, " %.*f", decimals, value);
    std::string_view digits(buffer, static_cast<std::size_t>(size));
    while (digits.ends_with('0'))
        digits.remove_suffix(1);
    if (digits.ends_with('.'))
        digits.remove_suffix(1);
    text += digits == " -0" ? " 0" : digits;
}

void appendVector(std::string& text, const char* keyword, const Vec3d& v, int decimals)
{
    text += keyword;
    for (const double component : {v.x, v.y, v.z})
        appendNumber(text, component, decimals);
    text += '\n';
}

struct Flat {
    double r, h;
    friend Flat operator+(Flat a, Flat b) { return {a.r + b.r, a.h + b.h}; }
    friend Flat operator-(Flat a, Flat b) { return {a.r - b.r, a.h - b.h}; }
    friend Flat operator*(double s, Flat a) { return {s * a.r, s * a.h}; }
};

double norm(Flat a)
{
    return std::hypot(a.r, a.h);
}

Flat unit(Flat a)
{
    return (1.0 / norm(a)) * a;
}

/// To the right of a direction.
Flat rightOf(Flat d)
{
    return {d.h, -d.r};
}

void addLine(std::vector<ProfilePoint>& profile, Flat from, Flat to, double step)
{
    const Flat normal = rightOf(unit(to - from));
    const int pieces = std::max(1, static_cast<int>(std::ceil(norm(to - from) / step)));
    for (int i = 0; i <= pieces; ++i) {
        const Flat p = from + (static_cast<double>(i) / pieces) * (to - from);
        profile.push_back({p.r, p.h, normal.r, normal.h});
    }
}

/// The arc that touches both legs of the corner, its ends excluded: the lines hold them. Normals turn evenly.
void addArc(std::vector<ProfilePoint>& profile, Flat corner, Flat in, Flat out, double rounding, double arcDegrees)
{
    const double turn = std::atan2(in.r * out.h - in.h * out.r, in.r * out.r + in.h * out.h);
    const double side = turn > 0.0 ? 1.0 : -1.0; // to the left: the arc's centre lies inside
    const Flat start = corner - (rounding * std::tan(std::fabs(turn) / 2.0)) * in;
    const Flat centre = start - (side * rounding) * rightOf(in);
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(std::fabs(turn) * 180.0 / std::numbers::pi / arcDegrees)));
    for (int i = 1; i < pieces; ++i) {
        const double a = turn * i / pieces;
        const Flat right = rightOf(in);
        const Flat normal{right.r * std::cos(a) - right.h * std::sin(a), right.r * std::sin(a) + right.h * std::cos(a)};
        const Flat p = centre + (side * rounding) * normal;
        profile.push_back({p.r, p.h, normal.r, normal.h});
    }
}

} // namespace

void addGrid(Shape& shape, const GridSize& size, const std::function<SurfacePoint(int row, int column)>& at)
{
    std::vector<Index> ids;
    for (int row = 0; row < size.rows; ++row) {
        std::vector<SurfacePoint> points;
        for (int column = 0; column < size.columns; ++column)
            points.push_back(at(row, column));
        const bool isPole = isOnePoint(points.data(), size.columns);
        for (int column = 0; column < size.columns; ++column) {
            if (column == 0 || !isPole)
                shape.points.push_back(points[static_cast<std::size_t>(column)]);
            ids.push_back(static_cast<Index>(shape.points.size() - 1));
        }
    }
    const auto id = [&](int row, int column) {
        return ids[static_cast<std::size_t>((row % size.rows) * size.columns + column % size.columns)];
    };
    for (int row = 0; row + (size.rowsClose ? 0 : 1) < size.rows; ++row)
        for (int column = 0; column + (size.columnsClose ? 0 : 1) < size.columns; ++column)
            addFace(shape, {id(row, column), id(row, column + 1), id(row + 1, column + 1), id(row + 1, column)});
}

std::vector<SurfacePoint> withNormals(const GridSize& size, const std::vector<Vec3d>& positions,
                                      const std::function<Vec3d(const Vec3d&)>& outward)
{
    const auto neighbour = [](int i, int step, int count, bool closes) {
        return closes ? (i + step + count) % count : std::clamp(i + step, 0, count - 1);
    };
    const auto at = [&](int row, int column) {
        return positions[static_cast<std::size_t>(row * size.columns + column)];
    };
    std::vector<SurfacePoint> points;
    for (int row = 0; row < size.rows; ++row)
        for (int column = 0; column < size.columns; ++column) {
            const auto alongRows = [&](int step) {
                return at(neighbour(row, step, size.rows, size.rowsClose), column);
            };
            const auto alongColumns = [&](int step) {
                return at(row, neighbour(column, step, size.columns, size.columnsClose));
            };
            Vec3d normal = normalized(cross(alongRows(1) - alongRows(-1), alongColumns(1) - alongColumns(-1)));
            if (dot(normal, outward(at(row, column))) < 0.0)
                normal = -normal;
            points.push_back({at(row, column), normal});
        }
    return points;
}

std::vector<ProfilePoint> roundedProfile(const std::vector<ProfileCorner>& corners, double arcDegrees, double step)
{
    std::vector<ProfilePoint> profile;
    const auto place = [&](std::size_t i) { return Flat{corners[i].radius, corners[i].height}; };
    Flat from = place(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Flat in = unit(place(i) - place(i - 1));
        const Flat out = unit(place(i + 1) - place(i));
        const double turn = std::acos(std::clamp(in.r * out.r + in.h * out.h, -1.0, 1.0));
        const double cut = corners[i].rounding * std::tan(turn / 2.0);
        addLine(profile, from, place(i) - cut * in, step);
        addArc(profile, place(i), in, out, corners[i].rounding, arcDegrees);
        from = place(i) + cut * out;
    }
    addLine(profile, from, place(corners.size() - 1), step);
    return profile;
}

void addRevolved(Shape& shape, const std::vector<ProfilePoint>& profile, int segments)
{
    const GridSize size{static_cast<int>(profile.size()), segments, false, true};
    addGrid(shape, size, [&](int row, int column) {
        const double angle = 2.0 * std::numbers::pi * column / segments;
        const ProfilePoint& p = profile[static_cast<std::size_t>(row)];
        const Vec3d out{std::cos(angle), 0.0, -std::sin(angle)};
        const Vec3d up{0.0, 1.0, 0.0};
        return SurfacePoint{p.radius * out + p.height * up, normalized(p.normalRadius * out + p.normalHeight * up)};
    });
}

std::string objText(const Shape& shape, const std::string& title, int decimals)
{
    std::string text = "# " + title + "\n# Made by tools/make_meshes; see meshes/README.md\n";
    for (const SurfacePoint& p : shape.points)
        appendVector(text, "v", p.position, decimals);
    for (const SurfacePoint& p : shape.points)
        appendVector(text, "vn", p.normal, 4);
    for (const auto& face : shape.faces) {
        text += 'f';
        for (const Index corner : face) {
            const std::string number = std::to_string(corner + 1);
            text += ' ' + number + "//" + number;
        }
        text += '\n';
    }
    return text;
}

} // namespace reflectance::stock
