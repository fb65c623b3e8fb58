#include "core/measured/rgl.h"

#include "core/measured/interpolate.h"

#include <algorithm>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rim = 1e-6; ///< radians: the file's angles are floats

double squareOfPolar(double theta)
{
    return std::sqrt(theta * (2.0 / pi));
}

/// Into 0 .. 1; an azimuth has no beginning.
double squareOfAzimuth(double phi)
{
    const double u = (phi + pi) / (2.0 * pi);
    return u - std::floor(u);
}

double polarOf(const Vec3d& v)
{
    return std::atan2(std::hypot(v.x, v.y), v.z);
}

/// One or two slices and their weights.
struct Slices {
    std::size_t first = 0;
    double weight[2] = {1.0, 0.0};

    [[nodiscard]] int count() const { return weight[1] > 0.0 ? 2 : 1; }
};

Slices slicesAt(const RglBrdf& brdf, double thetaI)
{
    const Place place = placeIn(brdf.thetaI, thetaI);
    return {place.below, {1.0 - place.t, place.t}};
}

/// The cumulative distribution at u of the mixture of the two slices' normalised densities.
UnitPoint unwarped(const RglBrdf& brdf, const Slices& slices, double x, double y)
{
    double left = 0.0;
    double all = 0.0;
    UnitPoint s;
    for (int k = 0; k < slices.count(); ++k) {
        const WarpedSquare& warp = brdf.warps[slices.first + static_cast<std::size_t>(k)];
        const double weight = slices.weight[k] / warp.total();
        left += weight * warp.leftOf(x, y);
        all += weight * warp.across(y);
        s.y += weight * warp.below(y);
    }
    s.x = all > 0.0 ? left / all : 0.0;
    return s;
}

} // namespace

std::optional<Mat3d> brdfAt(const RglBrdf& brdf, const Vec3d& L, const Vec3d& V)
{
    if (!(L.z > 0.0) || !(V.z > 0.0))
        return std::nullopt;
    const Vec3d m = normalized(L + V);
    const double thetaI = polarOf(L);
    if (!(thetaI >= brdf.thetaI.front() - rim && thetaI <= brdf.thetaI.back() + rim))
        return std::nullopt;
    const double phiI = std::atan2(L.y, L.x);
    const double polar = squareOfPolar(polarOf(m));
    const double azimuth = squareOfAzimuth(std::atan2(m.y, m.x) - phiI);
    const Slices slices = slicesAt(brdf, thetaI);
    const UnitPoint s = unwarped(brdf, slices, polar, azimuth);
    double scale = 1.0 / V.z;
    if (brdf.hasJacobian)
        scale *= brdf.ndf.at(polar, azimuth) / (4.0 * brdf.sigma.at(squareOfPolar(thetaI), squareOfAzimuth(phiI)));
    Channels f{};
    for (std::size_t c = 0; c < 3; ++c) {
        for (int k = 0; k < slices.count(); ++k)
            f[c] += slices.weight[k] * brdf.rgb[3 * (slices.first + static_cast<std::size_t>(k)) + c].at(s.x, s.y);
        f[c] = std::max(f[c], 0.0) * scale;
    }
    return std::isfinite(scale) ? std::optional(matrixOf(f, 3)) : std::nullopt;
}

} // namespace reflectance
