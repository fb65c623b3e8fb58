#include "core/illumination/harmonics.h"

#include "core/illumination/even_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {

std::array<double, 9> harmonicsAt(const Vec3d& d)
{
    const double norm = 0.5 * std::numbers::inv_sqrtpi;
    const double first = std::sqrt(3.0) * norm;
    const double second = std::sqrt(15.0) * norm;
    return {norm,
            first * d.y,
            first * d.z,
            first * d.x,
            second * d.x * d.y,
            second * d.y * d.z,
            0.5 * std::sqrt(5.0) * norm * (3.0 * d.z * d.z - 1.0),
            second * d.x * d.z,
            0.5 * second * (d.x * d.x - d.y * d.y)};
}

Harmonics projected(const std::function<Vec3d(const Vec3d&)>& radiance)
{
    constexpr int directions = 20000;
    Harmonics sum{};
    for (int i = 0; i < directions; ++i) {
        const Vec3d direction = evenDirection(i, directions);
        const Vec3d seen = radiance(direction);
        const auto weights = harmonicsAt(direction);
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += weights[k] * seen;
    }
    for (Vec3d& coefficient : sum)
        coefficient = coefficient * (4.0 * std::numbers::pi / directions);
    return sum;
}

Vec3d radianceOf(const Harmonics& coefficients, const Vec3d& direction)
{
    const auto weights = harmonicsAt(direction);
    Vec3d sum;
    for (std::size_t k = 0; k < coefficients.size(); ++k)
        sum += weights[k] * coefficients[k];
    return {std::max(0.0, sum.x), std::max(0.0, sum.y), std::max(0.0, sum.z)};
}

Environment environmentOf(const Harmonics& coefficients)
{
    constexpr int width = 128;
    constexpr int height = 64;
    auto map = std::make_shared<Image>(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const double longitude = 2.0 * std::numbers::pi * ((column + 0.5) / width - 0.5);
            const double latitude = std::numbers::pi * (row + 0.5) / height;
            const double across = std::sin(latitude);
            const Vec3d radiance = radianceOf(
                coefficients, {across * std::sin(longitude), std::cos(latitude), -across * std::cos(longitude)});
            float* rgb = map->at(column, row);
            rgb[0] = static_cast<float>(radiance.x);
            rgb[1] = static_cast<float>(radiance.y);
            rgb[2] = static_cast<float>(radiance.z);
        }
    Environment environment;
    environment.kind = EnvironmentKind::Map;
    environment.map = std::move(map);
    return environment;
}

} // namespace reflectance
