#include "core/sensor/picture.h"

#include "core/image/picture_file.h"

namespace reflectance {

PngColor pngColorOf(const Sensor& sensor)
{
    PngColor color{sensor.encoding.on ? sensor.encoding.kind : EncodingKind::Linear, 1.0};
    if (sensor.response.on && sensor.response.kind == ResponseKind::Gamma)
        color.gamma = sensor.response.gamma;
    return color;
}

Result<SensorCounts> savePicture(const std::string& path, const Image& image, const Sensor& sensor, const Notes& notes)
{
    const auto format = outputFormat(path);
    if (!format)
        return format.error();
    const Developed developed = develop(image, sensor);
    const auto written = [&] {
        if (*format != PictureFormat::Png)
            return writeLinear(path, image, notes);
        const PngColor color = pngColorOf(sensor);
        return isDeep(sensor) ? writePng(path, developed.width, developed.height, developed.deep, color, notes)
                              : writePng(path, developed.width, developed.height, developed.rgb, color, notes);
    }();
    if (!written)
        return written.error();
    return developed.counts;
}

} // namespace reflectance
