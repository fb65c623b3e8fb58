#include "core/sensor/stages.h"

#include "core/sensor/develop_text.h"

#include <algorithm>

namespace reflectance {
namespace {

double lightOf(double code, const Encoding& encoding)
{
    if (!encoding.on || encoding.kind == EncodingKind::Linear)
        return code;
    return encoding.kind == EncodingKind::Srgb ? decodeSrgb(code) : decodeRec709(code);
}

Image emptyLike(const Image& image)
{
    Image made(image.width, image.height);
    made.coverage = image.coverage;
    return made;
}

} // namespace

Image exposedLight(const Image& image, const Sensor& sensor)
{
    const double gain = gainOf(sensor);
    Image light = emptyLike(image);
    std::transform(image.rgb.begin(), image.rgb.end(), light.rgb.begin(),
                   [gain](float radiance) { return static_cast<float>(gain * double{radiance}); });
    return light;
}

Image sensedLight(const Image& image, const Sensor& sensor)
{
    DevelopText text = developText(sensor);
    Image light = emptyLike(image);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float* radiance = image.at(x, y);
            const Vec3d arrived = text.arriving({double{radiance[0]}, double{radiance[1]}, double{radiance[2]}}, x, y,
                                                image.width, image.height);
            const Vec3d linear = text.linearOf(arrived);
            float* sensed = light.at(x, y);
            sensed[0] = static_cast<float>(text.responded(linear.x, 0));
            sensed[1] = static_cast<float>(text.responded(linear.y, 1));
            sensed[2] = static_cast<float>(text.responded(linear.z, 2));
        }
    return light;
}

Image decodedLight(const Developed& developed, const Sensor& sensor)
{
    Image light(developed.width, developed.height);
    light.coverage.clear();
    for (std::size_t i = 0; i < light.rgb.size(); ++i) {
        const double code = developed.deep.empty() ? developed.rgb[i] / 255.0 : developed.deep[i] / 65535.0;
        light.rgb[i] = static_cast<float>(lightOf(code, sensor.encoding));
    }
    return light;
}

} // namespace reflectance
