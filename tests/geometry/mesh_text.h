// Small meshes as text, from which the tests make files of every format.
#pragma once

#include "core/geometry/load.h"

#include <string>
#include <vector>

namespace reflectance::testing {

/// The eight corners and six outward quads of the cube from (-1,-1,-1) to (1,1,1).
[[nodiscard]] const std::vector<Vec3d>& cubeCorners();
[[nodiscard]] const std::vector<std::vector<int>>& cubeQuads();

/// "v" lines of the cube's corners, and "f" lines of its quads (1-based).
[[nodiscard]] std::string cubeVertices();
[[nodiscard]] std::string cubeFaces();

/// A unit sphere by longitude and latitude without normals, turned into file coordinates by scale and offset.
[[nodiscard]] std::string sphereObj(int rows, int columns, double scale = 1.0, const Vec3d& offset = {});

/// The mesh, or a failed test and an empty one.
[[nodiscard]] LoadedMesh loaded(const std::string& bytes, const std::string& name = "test.obj",
                                const LoadOptions& options = {});

/// The sentence of the refusal; empty when the bytes were accepted.
[[nodiscard]] std::string refusal(const std::string& bytes, const std::string& name = "test.obj");

/// Area computed from the mesh as drawn, in its own units.
[[nodiscard]] double drawnArea(const Mesh& mesh);

} // namespace reflectance::testing
