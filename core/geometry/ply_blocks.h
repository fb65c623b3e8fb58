// Elements of a binary PLY file that all take the same number of bytes, read at once and on several threads: what fills
// nearly all large files.
#pragma once

#include "core/geometry/ply_header.h"
#include "core/geometry/polygon_soup.h"

#include <string_view>

namespace reflectance {

/// Reads the element's vertices if x, y and z are floats or doubles in the processor's byte order, not spread by lists, and
/// `bytes` holds all of them; with normals likewise. Returns how many bytes they took; 0, and does nothing, otherwise.
[[nodiscard]] std::size_t readVertexBlock(const PlyElement& element, std::string_view bytes, int threads,
                                          PolygonSoup& soup);

/// Reads the element's faces if every one is a list of three indices of four bytes behind a count of one byte, and nothing
/// else, and `bytes` holds all of them. Returns how many bytes they took; 0, and does nothing, otherwise.
[[nodiscard]] std::size_t readTriangleBlock(const PlyElement& element, std::string_view bytes, int threads,
                                            PolygonSoup& soup);

} // namespace reflectance
