#include "core/study/extremes/directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

double logOfCosine(double angle)
{
    const double sine = std::sin(0.5 * angle);
    return std::log1p(-2.0 * sine * sine);
}

} // namespace

Vec3d spread(std::size_t i, std::size_t count)
{
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double turn = static_cast<double>(i) * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    return normalized(Vec3d(r * std::cos(turn), r * std::sin(turn), z));
}

Vec3d tilted(const Vec3d& v, double angle, double azimuth)
{
    const Vec3d side = std::fabs(v.z) < 0.7 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
    const Vec3d a = normalized(cross(v, side));
    const Vec3d b = cross(v, a);
    return std::cos(angle) * v + std::sin(angle) * (std::cos(azimuth) * a + std::sin(azimuth) * b);
}

double angleOfVersine(double x)
{
    return 2.0 * std::asin(std::sqrt(0.5 * x));
}

double powerOfCosine(double angle, double n)
{
    return std::fabs(angle) < 0.5 * std::numbers::pi ? std::exp(n * logOfCosine(angle)) : 0.0;
}

double sensitivityOfPower(double angle, double n)
{
    return n * (std::tan(angle) - logOfCosine(angle));
}

} // namespace reflectance
