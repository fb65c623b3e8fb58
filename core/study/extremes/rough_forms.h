// Closed forms of rough matte surfaces in angles, for expected values: written apart from the shader texts, which use
// dot products.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {

/// A_F of Fujii's lobe: 1 / (1 + (1/2 - 2/(3 pi)) r).
[[nodiscard]] inline double fujiiFactor(double r)
{
    return 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * std::numbers::pi)) * r);
}

/// The full formula of Oren and Nayar 1994 as the lecture's factor (pi f cos), direct and interreflected; it may be
/// negative. Angles in radians.
[[nodiscard]] inline double fullOrenNayar(double rho, double sigma, double thetaL, double thetaV, double cosAzimuth)
{
    using std::numbers::pi;
    const double alpha = std::max(thetaL, thetaV);
    const double beta = std::min(thetaL, thetaV);
    const double s2 = sigma * sigma;
    const double shadow = 2.0 * beta / pi;
    const double bent = 4.0 * alpha * beta / (pi * pi);
    const double c1 = 1.0 - 0.5 * s2 / (s2 + 0.33);
    const double c2 =
        0.45 * s2 / (s2 + 0.09) * (std::sin(alpha) - (cosAzimuth >= 0.0 ? 0.0 : shadow * shadow * shadow));
    const double c3 = 0.125 * s2 / (s2 + 0.09) * bent * bent;
    const double direct =
        c1 + cosAzimuth * c2 * std::tan(beta) + (1.0 - std::fabs(cosAzimuth)) * c3 * std::tan(0.5 * (alpha + beta));
    const double second = 0.17 * rho * s2 / (s2 + 0.13) * (1.0 - cosAzimuth * shadow * shadow);
    return rho * std::cos(thetaL) * (direct + second);
}

} // namespace reflectance
