// The parts from which the stock meshes are built: grids of points with normals, revolved profiles, and their OBJ text.
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace reflectance::stock {

struct SurfacePoint {
    Vec3d position;
    Vec3d normal; ///< unit, outward
};

/// Faces of three or four corners; position i and normal i belong together.
struct Shape {
    std::vector<SurfacePoint> points;
    std::vector<std::vector<std::uint32_t>> faces;
};

struct GridSize {
    int rows = 2, columns = 2; ///< points, not faces
    bool rowsClose = false;    ///< the last row joins the first
    bool columnsClose = false;
};

/// Adds the grid of points at(row, column). A row whose points coincide becomes one vertex (a pole) with triangles.
/// Every face is wound so that its normals point outward.
void addGrid(Shape& shape, const GridSize& size, const std::function<SurfacePoint(int row, int column)>& at);

/// Unit normals of a grid of positions by central differences; `outward` tells which of the two sides is meant.
[[nodiscard]] std::vector<SurfacePoint> withNormals(const GridSize& size, const std::vector<Vec3d>& positions,
                                                    const std::function<Vec3d(const Vec3d&)>& outward);

/// A point of a profile in the half plane (radius, height), with the outward normal.
struct ProfilePoint {
    double radius, height;
    double normalRadius, normalHeight;
};

/// A corner of a profile and the radius of the arc that rounds it.
struct ProfileCorner {
    double radius, height, rounding;
};

/// A chain of straight lines with rounded corners, outward being to the right of its direction.
/// Arcs get a point every `arcDegrees`, straight pieces one every `step` at most.
[[nodiscard]] std::vector<ProfilePoint> roundedProfile(const std::vector<ProfileCorner>& corners, double arcDegrees,
                                                       double step);

/// The profile turned about the y axis.
void addRevolved(Shape& shape, const std::vector<ProfilePoint>& profile, int segments);

/// "v", "vn" and "f" lines. Positions with `decimals` digits after the point, normals with four.
[[nodiscard]] std::string objText(const Shape& shape, const std::string& title, int decimals);

} // namespace reflectance::stock
