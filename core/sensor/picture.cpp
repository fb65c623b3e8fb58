#include "core/sensor/picture.h"

#include "core/image/picture_file.h"

namespace reflectance {

Result<SensorCounts> savePicture(const std::string& path, const Image& image, const Sensor& sensor, const Notes& notes)
{
    const auto format = outputFormat(path);
    if (!format)
        return format.error();
    const Developed developed = develop(image, sensor);
    const auto written = *format == PictureFormat::Png
                             ? writePng(path, developed.width, developed.height, developed.rgb, notes)
                             : writeLinear(path, image, notes);
    if (!written)
        return written.error();
    return developed.counts;
}

} // namespace reflectance
