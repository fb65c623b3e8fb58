// A table in the form that renderers read: one array of texels, the same for float on the CPU and for a buffer texture.
#pragma once

#include "core/measured/table.h"

#include <cstdint>
#include <vector>

namespace reflectance {

/// The uniforms of shaders/measured/lookup.glsl.
struct TableTexels {
    std::vector<float> numbers; ///< four per texel: the angles of all axes, then the samples
    int system = 0, interpolation = 0;
    int rows = 1; ///< texels per sample
    bool isMatrix = false;
    int counts[3] = {1, 1, 1}; ///< samples along each axis

    [[nodiscard]] std::size_t texels() const { return numbers.size() / 4; }
};

/// Each number is rounded once.
[[nodiscard]] TableTexels texelsOf(const Table& table);

/// f(L, V) I in float, by the shared text; unit vectors about any N. 0 in holes and below the horizons.
[[nodiscard]] Vec3f lookedUp(const TableTexels& texels, const Vec3f& N, const Vec3f& L, const Vec3f& V, const Vec3f& I);

/// The same in double, by core/measured/table.h: the truth.
[[nodiscard]] Vec3d lookedUp(const Table& table, const Vec3d& N, const Vec3d& L, const Vec3d& V, const Vec3d& I);

/// True where light and viewer are above the surface and the table has no value for them.
[[nodiscard]] bool isHoleAt(const Table& table, const Vec3d& N, const Vec3d& L, const Vec3d& V);

/// What the object shows there, by the place on it.
[[nodiscard]] Vec3d holeColor(const Vec3d& P);

} // namespace reflectance
