// Where on the surface the model is evaluated. Samples decide what is seen; with fewer shadings than samples, colours are
// shared or interpolated: cheap where samples outnumber the places, and wrong where light changes between them.
#pragma once

#include <string_view>

namespace reflectance {

/// Sample: at every sample. Fragment: once per triangle in each pixel, at the middle one of its samples there, as
/// multisampling does. Pixel: once in each pixel, at the middle one of its samples, whatever they see.
/// Vertex: at the mesh's vertices, interpolated over triangles (Gouraud, Continuous Shading of Curved Surfaces, IEEE Trans.
/// Computers C-20(6), 1971); each side of the surface has its own colours, since the normal turns to the viewer's side.
/// Face: once per triangle, at its centroid with its own normal.
enum class Place { Sample, Fragment, Pixel, Vertex, Face };

[[nodiscard]] constexpr std::string_view nameOf(Place place)
{
    constexpr std::string_view names[] = {"sample", "fragment", "pixel", "vertex", "face"};
    return names[static_cast<int>(place)];
}

} // namespace reflectance
