#include "core/sensor/sensor.h"

#include "core/base/parallel.h"
#include "core/sensor/develop_text.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

Vec3d radianceAt(const Image& image, int x, int y)
{
    const float* rgb = image.at(x, y);
    return {double{rgb[0]}, double{rgb[1]}, double{rgb[2]}};
}

void count(SensorCounts& counts, const float* rgb, bool clipped)
{
    const auto any = [rgb](auto holds) { return std::any_of(rgb, rgb + 3, holds); };
    counts.negative += any([](float c) { return c < 0.0F; });
    counts.clipped += clipped;
    counts.nonFinite += any([](float c) { return !std::isfinite(c); });
}

std::uint16_t quantisedDeep(double encoded)
{
    if (!(encoded > 0.0))
        return 0;
    return static_cast<std::uint16_t>(std::floor(65535.0 * std::min(encoded, 1.0) + 0.5));
}

void developRow(const Image& image, int y, DevelopText& text, Developed& picture, SensorCounts& counts)
{
    std::size_t at = 3 * Image::pixelCount(image.width, y);
    for (int x = 0; x < image.width; ++x) {
        const Vec3d radiance = radianceAt(image, x, y);
        const Vec3d arrived = text.arriving(radiance, x, y, image.width, image.height);
        const Vec3d linear = text.linearOf(arrived);
        const bool clipped = text.isClipped(arrived, linear);
        count(counts, &image.rgb[at], clipped);
        const Vec3d code = text.finished(radiance, linear, clipped, x, y);
        for (const double channel : {code.x, code.y, code.z}) {
            picture.rgb[at] = quantised(channel);
            if (!picture.deep.empty())
                picture.deep[at] = quantisedDeep(channel);
            ++at;
        }
    }
}

} // namespace

double gainOf(const Sensor& sensor)
{
    const double gain = sensor.exposes ? std::exp2(sensor.exposure) : 1.0;
    const CameraExposure& camera = sensor.camera;
    if (!camera.on)
        return gain;
    return gain * camera.white * camera.shutter * camera.iso / (120.0 * camera.aperture * camera.aperture);
}

double electronsAtWhite(const Sensor& sensor)
{
    return sensor.camera.on ? sensor.noise.fullWell * 100.0 / sensor.camera.iso : sensor.noise.fullWell;
}

bool isDeep(const Sensor& sensor)
{
    return !sensor.quantisation.on || sensor.quantisation.bits > 8;
}

Developed develop(const Image& image, const Sensor& sensor)
{
    const DevelopText shared = developText(sensor);
    const bool deep = isDeep(sensor);
    Developed picture{image.width, image.height, std::vector<std::uint8_t>(image.rgb.size()), {}, {}};
    picture.deep.resize(deep ? image.rgb.size() : 0);
    constexpr std::size_t rowsPerRange = 16;
    const auto rows = static_cast<std::size_t>(image.height);
    std::vector<SensorCounts> counts((rows + rowsPerRange - 1) / rowsPerRange);
    inRanges(threadsFor(0), rows, rowsPerRange, [&](std::size_t range, std::size_t first, std::size_t last) {
        DevelopText text = shared;
        for (std::size_t y = first; y < last; ++y)
            developRow(image, static_cast<int>(y), text, picture, counts[range]);
    });
    for (const SensorCounts& range : counts) {
        picture.counts.negative += range.negative;
        picture.counts.clipped += range.clipped;
        picture.counts.nonFinite += range.nonFinite;
    }
    return picture;
}

Vec3d developedAt(const Image& image, int x, int y, const Sensor& sensor)
{
    return developText(sensor).develop(radianceAt(image, x, y), x, y, image.width, image.height);
}

double encodeSrgb(double linear)
{
    return DevelopText{}.encodeSrgb(linear);
}

std::uint8_t quantised(double encoded)
{
    if (!(encoded > 0.0))
        return 0;
    return static_cast<std::uint8_t>(std::floor(255.0 * std::min(encoded, 1.0) + 0.5));
}

} // namespace reflectance
