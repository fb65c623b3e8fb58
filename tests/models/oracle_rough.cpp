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

Real cubed(const Real& v)
{
    return v * v * v;
}

/// The bracket of the direct light; that of the second bounce stands below, since rho enters it once more.
Real direct(const Inputs& x, const Angles& a)
{
    const Real s2 = x[atParameters + 3] * x[atParameters + 3];
    const Real C1 = 1 - s2 / (s2 + Real("0.33")) / 2;
    const Real towards = sin(a.alpha) - (a.cosAzimuth >= 0 ? Real(0) : cubed(2 * a.beta / pi()));
    const Real C2 = Real("0.45") * s2 / (s2 + Real("0.09")) * towards;
    const Real bent = 4 * a.alpha * a.beta / (pi() * pi());
    const Real C3 = Real("0.125") * s2 / (s2 + Real("0.09")) * bent * bent;
    return C1 + a.cosAzimuth * C2 * tan(a.beta) + (1 - abs(a.cosAzimuth)) * C3 * tan((a.alpha + a.beta) / 2);
}

Real second(const Inputs& x, const Angles& a)
{
    const Real s2 = x[atParameters + 3] * x[atParameters + 3];
    const Real shadow = 2 * a.beta / pi();
    return Real("0.17") * s2 / (s2 + Real("0.13")) * (1 - a.cosAzimuth * shadow * shadow);
}

Three orenNayarFull(const Inputs& x)
{
    Three result = matte(x, direct);
    const Three bounced = matte(x, second);
    for (std::size_t i = 0; i < 3; ++i)
        result[i] += x[atParameters + i] * bounced[i];
    return result;
}

Real fujiiConstant()
{
    return Real(1) / 2 - 2 / (3 * pi());
}

Real fujii(const Inputs& x, const Angles& a)
{
    const Real r = x[atParameters + 3];
    const Real s = a.cosAzimuth * sin(a.alpha) * sin(a.beta);
    const Real t = s > 0 ? Real(cos(a.beta)) : Real(1);
    return (1 + r * s / t) / (1 + fujiiConstant() * r);
}

Three orenNayarFujii(const Inputs& x)
{
    return matte(x, fujii);
}

/// G of the paper, with mu = cos(theta).
Real exactG(const Real& theta)
{
    const Real S = sin(theta);
    return S * (theta - S * cos(theta)) + 2 * (S / cos(theta) * (1 - cubed(S)) - S) / 3;
}

/// The polynomial, held where the albedo of the first bounce would exceed 1.
Real polynomialG(const Real& theta)
{
    const Real m = 1 - cos(theta);
    const Real share = Real("0.0571085289") * m + Real("0.491881867") * m * m - Real("0.332181442") * m * m * m +
                       Real("0.0714429953") * m * m * m * m;
    return std::min(Real(pi() * share), Real(pi() * fujiiConstant()));
}

/// The lobe of many bounces, as in the paper: rho_ms (1 - E)(1 - E) / (1 - <E>).
Three eonWith(const Inputs& x, Real (*G)(const Real&))
{
    Three result = matte(x, fujii);
    const Real r = x[atParameters + 3];
    if (!above(x, atL) || !above(x, atV) || r == 0)
        return result;
    const Angles a = anglesOf(x);
    const Real AF = 1 / (1 + fujiiConstant() * r);
    const Real mean = AF * (1 + (Real(2) / 3 - 28 / (15 * pi())) * r);
    const auto E = [&](const Real& theta) { return AF + r * AF / pi() * G(theta); };
    const Real shape = (1 - E(a.alpha)) * (1 - E(a.beta)) / (1 - mean) * cos(a.thetaL);
    for (std::size_t i = 0; i < 3; ++i) {
        const Real rho = x[atParameters + i];
        result[i] += rho * rho * mean / (1 - rho * (1 - mean)) * shape * x[atI + i];
    }
    return result;
}

Three eon(const Inputs& x)
{
    return eonWith(x, exactG);
}

Three eonPolynomial(const Inputs& x)
{
    return eonWith(x, polynomialG);
}

} // namespace

Formulas roughFormulas()
{
    return {{"oren_nayar", {{{"rho", 3}, {"sigma"}}, orenNayar}},
            {"oren_nayar_full", {{{"rho", 3}, {"sigma"}}, orenNayarFull}},
            {"oren_nayar_fujii", {{{"rho", 3}, {"r"}}, orenNayarFujii}},
            {"eon", {{{"rho", 3}, {"r"}}, eon}},
            {"eon_polynomial", {{{"rho", 3}, {"r"}}, eonPolynomial}}};
}

} // namespace reflectance::test
