#include "core/image/colour_difference.h"

#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;

/// The cube root with a straight line below (6/29)^3.
double compressed(double ratio)
{
    constexpr double delta = 6.0 / 29.0;
    return ratio > delta * delta * delta ? std::cbrt(ratio) : ratio / (3.0 * delta * delta) + 4.0 / 29.0;
}

double displayed(float channel)
{
    return channel > 0.0F ? std::fmin(double{channel}, 1.0) : 0.0;
}

double hueOf(double a, double b)
{
    const double hue = a == 0.0 && b == 0.0 ? 0.0 : std::atan2(b, a);
    return hue < 0.0 ? hue + 2.0 * pi : hue;
}

/// From h1 to h2 the short way round; 0 where one of the colours is grey.
double hueDifference(double h1, double h2, bool grey)
{
    const double difference = h2 - h1;
    if (grey)
        return 0.0;
    return difference > pi ? difference - 2.0 * pi : difference < -pi ? difference + 2.0 * pi : difference;
}

double meanHue(double h1, double h2, bool grey)
{
    const double sum = h1 + h2;
    if (grey)
        return sum;
    if (std::fabs(h1 - h2) <= pi)
        return 0.5 * sum;
    return sum < 2.0 * pi ? 0.5 * (sum + 2.0 * pi) : 0.5 * (sum - 2.0 * pi);
}

double seventhRatio(double chroma)
{
    const double seventh = std::pow(chroma, 7.0);
    return std::sqrt(seventh / (seventh + 6103515625.0)); // 25^7
}

double hueWeight(double hue)
{
    return 1.0 - 0.17 * std::cos(hue - pi / 6.0) + 0.24 * std::cos(2.0 * hue) + 0.32 * std::cos(3.0 * hue + pi / 30.0) -
           0.20 * std::cos(4.0 * hue - 63.0 * pi / 180.0);
}

} // namespace

Lab labOf(const Vec3d& XYZ, const Vec3d& white)
{
    const double fx = compressed(XYZ.x / white.x);
    const double fy = compressed(XYZ.y / white.y);
    const double fz = compressed(XYZ.z / white.z);
    return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

Vec3d xyzOf(const Vec3d& rgb)
{
    return {0.4124564 * rgb.x + 0.3575761 * rgb.y + 0.1804375 * rgb.z,
            0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z,
            0.0193339 * rgb.x + 0.1191920 * rgb.y + 0.9503041 * rgb.z};
}

Lab labOfDisplayed(const float* rgb)
{
    static const Vec3d white = xyzOf({1.0, 1.0, 1.0});
    return labOf(xyzOf({displayed(rgb[0]), displayed(rgb[1]), displayed(rgb[2])}), white);
}

double deltaE2000(const Lab& one, const Lab& other)
{
    const double meanChroma = 0.5 * (std::hypot(one.a, one.b) + std::hypot(other.a, other.b));
    const double stretch = 1.0 + 0.5 * (1.0 - seventhRatio(meanChroma));
    const double a1 = one.a * stretch;
    const double a2 = other.a * stretch;
    const double C1 = std::hypot(a1, one.b);
    const double C2 = std::hypot(a2, other.b);
    const bool grey = C1 * C2 == 0.0;
    const double h1 = hueOf(a1, one.b);
    const double h2 = hueOf(a2, other.b);

    const double dL = other.L - one.L;
    const double dC = C2 - C1;
    const double dH = 2.0 * std::sqrt(C1 * C2) * std::sin(0.5 * hueDifference(h1, h2, grey));

    const double L = 0.5 * (one.L + other.L);
    const double C = 0.5 * (C1 + C2);
    const double hue = meanHue(h1, h2, grey);
    const double fromMiddle = (L - 50.0) * (L - 50.0);
    const double SL = 1.0 + 0.015 * fromMiddle / std::sqrt(20.0 + fromMiddle);
    const double SC = 1.0 + 0.045 * C;
    const double SH = 1.0 + 0.015 * C * hueWeight(hue);
    const double fromBlue = (hue * 180.0 / pi - 275.0) / 25.0;
    const double turn = -std::sin(pi / 3.0 * std::exp(-fromBlue * fromBlue)) * 2.0 * seventhRatio(C);
    const double l = dL / SL;
    const double c = dC / SC;
    const double h = dH / SH;
    return std::sqrt(std::fmax(0.0, l * l + c * c + h * h + turn * c * h));
}

} // namespace reflectance
