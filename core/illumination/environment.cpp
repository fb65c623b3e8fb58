#include "core/illumination/environment.h"

#include "core/image/picture_file.h"

#include "illumination_texts.gen.h"

#include <numbers>

namespace reflectance {
namespace {

template <class T> Vec3<T> turned(const Vec3<T>& d, double degrees)
{
    if (degrees == 0.0)
        return d;
    const double angle = degrees * std::numbers::pi / 180.0;
    const T c = static_cast<T>(std::cos(angle));
    const T s = static_cast<T>(std::sin(angle));
    return {c * d.x - s * d.z, d.y, s * d.x + c * d.z};
}

template <class T> Vec3<T> texel(const Image& map, int column, int row)
{
    const float* rgb = map.at((column + map.width) % map.width, std::clamp(row, 0, map.height - 1));
    return {T(rgb[0]), T(rgb[1]), T(rgb[2])};
}

template <class T> Vec3<T> lookedUp(const Image& map, const Vec3<T>& d)
{
    constexpr T pi = std::numbers::pi_v<T>;
    const T u = T(0.5) + std::atan2(d.x, -d.z) / (T(2) * pi);
    const T v = std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y) / pi;
    if (std::isnan(u + v))
        return Vec3<T>(u + v);
    const T x = u * T(map.width) - T(0.5);
    const T y = v * T(map.height) - T(0.5);
    const int column = static_cast<int>(std::floor(x));
    const int row = static_cast<int>(std::floor(y));
    const T shareX = x - std::floor(x);
    const Vec3<T> above = mix(texel<T>(map, column, row), texel<T>(map, column + 1, row), shareX);
    const Vec3<T> below = mix(texel<T>(map, column, row + 1), texel<T>(map, column + 1, row + 1), shareX);
    return mix(above, below, y - std::floor(y));
}

template <class T> Vec3<T> arriving(const Environment& environment, const Vec3<T>& direction)
{
    const Vec3<T> factor(environment.radiance);
    switch (environment.kind) {
    case EnvironmentKind::None:
        return {};
    case EnvironmentKind::Constant:
        return factor;
    case EnvironmentKind::Studio:
        return factor * texts::Studio<T>().studioRadiance(turned(direction, environment.rotation));
    case EnvironmentKind::Map:
        return environment.map ? factor * lookedUp(*environment.map, turned(direction, environment.rotation))
                               : Vec3<T>();
    }
    return {};
}

} // namespace

Vec3d radianceFrom(const Environment& environment, const Vec3d& direction)
{
    return arriving(environment, direction);
}

Vec3f radianceFrom(const Environment& environment, const Vec3f& direction)
{
    return arriving(environment, direction);
}

Result<Environment> loadEnvironment(const std::string& path)
{
    auto picture = readPicture(path);
    if (!picture)
        return picture.error();
    if (!picture->isLinear())
        return Error{"a PNG holds no linear radiance; give an OpenEXR or Radiance HDR picture", path};
    Environment environment;
    environment.kind = EnvironmentKind::Map;
    environment.file = path;
    environment.map = std::make_shared<const Image>(std::move(picture->image));
    return environment;
}

} // namespace reflectance
