#include "core/image/picture_file.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/image/formats.h"

#include <optional>

namespace reflectance {
namespace {

std::optional<PictureFormat> formatOf(std::string_view bytes)
{
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"))
        return PictureFormat::Png;
    if (bytes.starts_with("\x76\x2f\x31\x01"))
        return PictureFormat::Exr;
    if (bytes.starts_with("PF") || bytes.starts_with("Pf"))
        return PictureFormat::Pfm;
    if (bytes.starts_with("#?"))
        return PictureFormat::Hdr;
    return std::nullopt;
}

Result<Image> decoded(PictureFormat format, std::string_view bytes, const std::string& path)
{
    switch (format) {
    case PictureFormat::Png:
        return decodedPng(bytes, path);
    case PictureFormat::Exr:
        return decodedExr(bytes, path);
    case PictureFormat::Pfm:
        return decodedPfm(bytes, path);
    case PictureFormat::Hdr:
        break;
    }
    return decodedHdr(bytes, path);
}

} // namespace

Result<PictureFormat> outputFormat(const std::string& path)
{
    const std::string name = lowered(path);
    if (name.ends_with(".png"))
        return PictureFormat::Png;
    if (name.ends_with(".exr"))
        return PictureFormat::Exr;
    if (name.ends_with(".pfm"))
        return PictureFormat::Pfm;
    return Error{"names no picture format that can be written; end it in .png, .exr or .pfm", path};
}

Result<Picture> decodedPicture(std::string_view bytes, const std::string& path)
{
    const auto format = formatOf(bytes);
    if (!format)
        return Error{"is not a picture of a known format; PNG, OpenEXR, PFM and Radiance HDR are read", path};
    auto image = decoded(*format, bytes, path);
    if (!image)
        return image.error();
    return Picture{*std::move(image), *format};
}

Result<Notes> decodedNotes(std::string_view bytes, const std::string& path)
{
    const auto format = formatOf(bytes);
    if (!format)
        return Error{"is not a picture of a known format; PNG and OpenEXR files carry sessions", path};
    if (*format == PictureFormat::Png)
        return notesOfPng(bytes, path);
    return *format == PictureFormat::Exr ? notesOfExr(bytes, path) : Notes();
}

Result<Picture> readPicture(const std::string& path)
{
    const auto bytes = readWholeFile(path);
    if (!bytes)
        return bytes.error();
    return decodedPicture(*bytes, path);
}

Result<void> writeLinear(const std::string& path, const Image& image, const Notes& notes)
{
    const auto format = outputFormat(path);
    if (!format)
        return format.error();
    if (*format == PictureFormat::Png)
        return Error{"a PNG holds no linear values; end the name in .exr or .pfm", path};
    return writeAtomically(path, *format == PictureFormat::Exr ? encodedExr(image, notes) : encodedPfm(image));
}

Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb,
                      const PngColor& color, const Notes& notes)
{
    return writeAtomically(path, encodedPng(width, height, rgb, color, notes));
}

Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint16_t> rgb,
                      const PngColor& color, const Notes& notes)
{
    return writeAtomically(path, encodedPng(width, height, rgb, color, notes));
}

} // namespace reflectance
