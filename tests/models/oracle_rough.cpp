// Matte surfaces with a profile, in the angles of the papers.
#include "tests/models/oracle_math.h"

#include <algorithm>

namespace reflectance::test {
namespace {

/// The two polar angles, and the cosine of the azimuth between light and viewer (0 where one of them stands at N).
struct Angles {
    Real alpha, beta; ///< the larger and the smaller of the two
    Real thetaL;
    Real cosAzimuth;
};

Angles anglesOf(const Inputs& x)
{
    const Three N = three(x, atN);
    const Three L = three(x, atL);
    const Three V = three(x, atV);
    const Real thetaL = angle(N, L);
    const Real thetaV = angle(N, V);
    // The planes of N and L and of N and V are as far apart as their normals.
    const Three planeL = cross(N, L);
    const Three planeV = cross(N, V);
    const Real lengths = sqrt(dot(planeL, planeL) * dot(planeV, planeV));
    return {std::max(thetaL, thetaV), std::min(thetaL, thetaV), thetaL,
            lengths == 0 ? Real(0) : Real(dot(planeL, planeV) / lengths)};
}

/// rho I cos(theta_L) times the bracket, 0 unless light and viewer are both above the surface.
Three matte(const Inputs& x, Real (*bracket)(const Inputs&, const Angles&))
{
    if (!above(x, atL) || !above(x, atV))
        return {};
    const Angles angles = anglesOf(x);
    return scaled(colorTimesLight(x, atParameters), cos(angles.thetaL) * bracket(x, angles));
}

Real qualitative(const Inputs& x, const Angles& a)
{
    const Real s2 = x[atParameters + 3] * x[atParameters + 3];
    const Real A = 1 - s2 / (s2 + Real("0.33")) / 2;
    const Real B = Real("0.45") * s2 / (s2 + Real("0.09"));
    return A + B * std::max(Real(0), a.cosAzimuth) * sin(a.alpha) * tan(a.beta);
}

Three orenNayar(const Inputs& x)
{
    return matte(x, qualitative);
}

} // namespace

Formulas roughFormulas()
{
    return {{"oren_nayar", {{"rho", "sigma"}, orenNayar}}};
}

} // namespace reflectance::test
