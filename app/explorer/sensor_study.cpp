#include "app/explorer/sensor_study.h"

#include "core/render/pictures/picture_waterfall.h"
#include "core/sensor/stages.h"

namespace reflectance::explorer {

std::optional<PixelReading> readingOf(const Image& linear, const Sensor& sensor, int x, int y)
{
    if (x < 0 || y < 0 || x >= linear.width || y >= linear.height)
        return std::nullopt;
    const float* rgb = linear.at(x, y);
    return PixelReading{x, y, {double{rgb[0]}, double{rgb[1]}, double{rgb[2]}}, developedAt(linear, x, y, sensor)};
}

std::optional<Waterfall> windowWaterfall(const Scene& scene, const DrawnByGl& drawn, Progress& progress)
{
    const Image exact = shadeSamples(drawn.samples, scene, Precision::Double, &progress);
    if (progress.cancel)
        return std::nullopt;
    std::vector<WaterfallPicture> pictures = picturesOfSensor(exact, drawn.linear, scene.sensor);
    if (scene.other) {
        const Image other = shadeSamples(drawn.samples, variantB(scene), Precision::Double, &progress);
        pictures.front().step = "model";
        pictures.insert(pictures.begin(), {"truth", exposedLight(other, scene.sensor)});
    }
    if (progress.cancel)
        return std::nullopt;
    auto waterfall = waterfallOf(pictures);
    return waterfall ? std::optional(*std::move(waterfall)) : std::nullopt;
}

} // namespace reflectance::explorer
