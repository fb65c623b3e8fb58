#include "core/geometry/corner_angles.h"

#include "core/base/parallel.h"
#include "core/geometry/arctangent.h"
#include "core/geometry/triangle_loops.h"

namespace reflectance {
namespace {

using Angles = std::array<double, 3>;

double angleBetween(const Vec3d& u, const Vec3d& w)
{
    const Vec3d n = cross(u, w);
    return arctangent(std::sqrt(dot(n, n)), dot(u, w));
}

/// Of sides that are so long or short that their products would overflow or vanish.
Angles anglesOf(const TriangleSides<double>& sides)
{
    const Vec3d ab = normalized(sides.ab);
    const Vec3d ac = normalized(sides.ac);
    const Vec3d bc = normalized(sides.bc);
    return {angleBetween(ab, ac), angleBetween(-ab, bc), angleBetween(ac, bc)};
}

} // namespace

double angleOf(double sine, double cosine)
{
    return arctangent(sine, cosine);
}

UnfilledVector<Angles> cornerAngles(std::span<const Vec3d> positions, std::span<const Mesh::Triangle> triangles,
                                    int threads)
{
    UnfilledVector<Angles> angles(triangles.size());
    const auto vertexAt = [triangles](std::size_t t, std::size_t k) { return triangles[t][k]; };
    inBlocks(threads, positions, triangles.size(), vertexAt, [&](const TriangleBlock& block) {
        AngleBlock found;
        triangleLoops().angles(block, found);
        for (std::size_t i = 0; i < block.count; ++i)
            angles[block.first + i] = isHandySize(found.sizes[i])
                                          ? Angles{found.angles[0][i], found.angles[1][i], found.angles[2][i]}
                                          : anglesOf(block.sides(i));
    });
    return angles;
}

} // namespace reflectance
