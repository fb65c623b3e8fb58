#include "core/sensor/sensor.h"

#include "core/base/parallel.h"
#include "sensor_texts.gen.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

void count(SensorCounts& counts, const float* rgb, double gain)
{
    const auto any = [rgb](auto holds) { return std::any_of(rgb, rgb + 3, holds); };
    counts.negative += any([](float c) { return c < 0.0F; });
    counts.clipped += any([gain](float c) { return gain * double{c} > 1.0; });
    counts.nonFinite += any([](float c) { return !std::isfinite(c); });
}

} // namespace

Developed develop(const Image& image, const Sensor& sensor)
{
    texts::Develop<double> text;
    text.exposure = sensor.exposure;
    const double gain = std::exp2(sensor.exposure);
    Developed picture{image.width, image.height, std::vector<std::uint8_t>(image.rgb.size()), {}};
    constexpr std::size_t pixelsPerRange = 16384;
    std::vector<SensorCounts> counts((image.pixels() + pixelsPerRange - 1) / pixelsPerRange);
    inRanges(threadsFor(0), image.pixels(), pixelsPerRange,
             [&](std::size_t range, std::size_t first, std::size_t last) {
                 float radiance = 0.0F; // grey pixels and plain backgrounds repeat it: the curve's power is what costs
                 std::uint8_t code = quantised(text.developChannel(0.0));
                 for (std::size_t i = 3 * first; i < 3 * last; ++i) {
                     if (image.rgb[i] != radiance) {
                         radiance = image.rgb[i];
                         code = quantised(text.developChannel(double{radiance}));
                     }
                     picture.rgb[i] = code;
                 }
                 for (std::size_t i = first; i < last; ++i)
                     count(counts[range], &image.rgb[3 * i], gain);
             });
    for (const SensorCounts& range : counts) {
        picture.counts.negative += range.negative;
        picture.counts.clipped += range.clipped;
        picture.counts.nonFinite += range.nonFinite;
    }
    return picture;
}

double encodeSrgb(double linear)
{
    return texts::Develop<double>().encodeSrgb(linear);
}

std::uint8_t quantised(double encoded)
{
    if (!(encoded > 0.0))
        return 0;
    return static_cast<std::uint8_t>(std::floor(255.0 * std::min(encoded, 1.0) + 0.5));
}

} // namespace reflectance
