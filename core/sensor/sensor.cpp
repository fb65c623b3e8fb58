#include "core/sensor/sensor.h"

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
    std::transform(image.rgb.begin(), image.rgb.end(), picture.rgb.begin(),
                   [&text](float radiance) { return quantised(text.developChannel(double{radiance})); });
    for (std::size_t i = 0; i < image.pixels(); ++i)
        count(picture.counts, &image.rgb[3 * i], gain);
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
