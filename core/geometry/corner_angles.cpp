#include "core/geometry/corner_angles.h"

#include "core/base/parallel.h"
#include "core/geometry/triangle_block.h"

#include <numbers>

namespace reflectance {
namespace {

using Angles = std::array<double, 3>;

/// atan(r) = r + r z Q(z), z = r^2, for |r| <= tan(pi/8), lowest power first: the polynomial of the least largest relative
/// error (Remez), 0.011 units in the last place, so that roundings are all there is.
constexpr std::array<double, 11> Q{-0.33333333333333129103,  0.19999999999942733392,   -0.14285714279417031893,
                                   0.11111110752669240245,   -0.090908970192096296224, 0.076920488846111465172,
                                   -0.066629904176082746239, 0.058471477427401981026,  -0.050362704432905344382,
                                   0.037993873485346485028,  -0.01783567689269622686};

[[gnu::always_inline]] inline double arctangent(double sine, double cosine)
{
    using std::numbers::pi;
    constexpr double tanOfEighth = 0.41421356237309504880;
    const double size = std::fabs(cosine);
    const double low = std::min(sine, size);
    const double high = std::max(sine, size);
    // Beyond pi/8 what is left of pi/4: tan(a - pi/4) = (tan a - 1) / (tan a + 1). One division serves both.
    const bool isWide = low > tanOfEighth * high;
    const double r = (isWide ? low - high : low) / (isWide ? low + high : high);
    const double z = r * r;
    double sum = Q.back();
    for (std::size_t i = Q.size() - 1; i-- > 0;)
        sum = sum * z + Q[i];
    const double small = (isWide ? 0.25 * pi : 0.0) + (r + r * (z * sum));
    const double acute = sine > size ? 0.5 * pi - small : small;
    return cosine < 0.0 ? pi - acute : acute;
}

double angleBetween(const Vec3d& u, const Vec3d& w)
{
    const Vec3d n = cross(u, w);
    return arctangent(std::sqrt(dot(n, n)), dot(u, w));
}

/// Of sides that are so long or short that their products would overflow or vanish.
Angles anglesOf(const TriangleSides& sides)
{
    const Vec3d ab = normalized(sides.ab);
    const Vec3d ac = normalized(sides.ac);
    const Vec3d bc = normalized(sides.bc);
    return {angleBetween(ab, ac), angleBetween(-ab, bc), angleBetween(ac, bc)};
}

/// The angles of a block of triangles; those of unhandy ones are nonsense.
struct AngleBlock {
    std::array<std::array<double, TriangleBlock::capacity>, 3> angles;
    std::array<bool, TriangleBlock::capacity> isHandy;

    explicit AngleBlock(const TriangleBlock& block)
    {
        for (std::size_t i = 0; i < TriangleBlock::capacity; ++i) {
            const TriangleSides sides = block.sides(i);
            const Vec3d n = sides.normal();
            const double sine = std::sqrt(dot(n, n));
            angles[0][i] = arctangent(sine, dot(sides.ab, sides.ac));
            angles[1][i] = arctangent(sine, -dot(sides.ab, sides.bc));
            angles[2][i] = arctangent(sine, dot(sides.ac, sides.bc));
        }
        for (std::size_t i = 0; i < TriangleBlock::capacity; ++i)
            isHandy[i] = TriangleSides::isHandy(block.sides(i).size());
    }
};

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
        const AngleBlock found(block);
        for (std::size_t i = 0; i < block.count; ++i)
            angles[block.first + i] = found.isHandy[i]
                                          ? Angles{found.angles[0][i], found.angles[1][i], found.angles[2][i]}
                                          : anglesOf(block.sides(i));
    });
    return angles;
}

} // namespace reflectance
