// PFM: "PF\n", width and height, a scale whose sign tells the byte order, then floats with rows from the bottom.
#include "core/image/formats.h"

#include "core/base/text.h"
#include "core/image/dimensions.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace reflectance {
namespace {

static_assert(std::endian::native == std::endian::little, "the byte order of PFM and EXR files is turned for this");

struct PfmHeader {
    long width = 0, height = 0;
    double scale = 0.0;
    std::size_t channels = 0;
    std::size_t data = 0; ///< where the floats begin
};

constexpr std::string_view blanks = " \t\r\n";

/// The header's fields are separated by any blanks; exactly one blank follows the last.
std::optional<PfmHeader> headerOf(std::string_view bytes)
{
    std::string_view fields[4];
    std::size_t at = 0;
    for (std::string_view& field : fields) {
        at = bytes.find_first_not_of(blanks, at);
        const std::size_t end = bytes.find_first_of(blanks, at);
        if (at == std::string_view::npos || end == std::string_view::npos)
            return std::nullopt;
        field = bytes.substr(at, end - at);
        at = end;
    }
    const auto width = parseInteger(fields[1]);
    const auto height = parseInteger(fields[2]);
    const auto scale = parseNumber(fields[3]);
    if ((fields[0] != "PF" && fields[0] != "Pf") || !width || !height || !scale || *scale == 0.0 ||
        !std::isfinite(*scale))
        return std::nullopt;
    return PfmHeader{*width, *height, *scale, fields[0] == "PF" ? 3U : 1U, at + 1};
}

float floatAt(const char* bytes, bool bigEndian)
{
    std::uint32_t bits = 0;
    std::memcpy(&bits, bytes, sizeof bits);
    return std::bit_cast<float>(bigEndian ? __builtin_bswap32(bits) : bits);
}

} // namespace

Result<Image> decodedPfm(std::string_view bytes, const std::string& path)
{
    const auto header = headerOf(bytes);
    if (!header)
        return Error{"is not a PFM picture: it must begin with PF or Pf, width, height and a scale other than 0", path};
    if (const auto size = checkDimensions(header->width, header->height, bytes.size(), 1, path); !size)
        return size.error();
    const std::size_t stride = 4 * header->channels;
    Image image(static_cast<int>(header->width), static_cast<int>(header->height));
    image.coverage.clear();
    if (bytes.size() < header->data + stride * image.pixels())
        return Error{"is cut short: its values end too early", path};
    const auto magnitude = static_cast<float>(std::fabs(header->scale));
    const char* from = bytes.data() + header->data;
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x, from += stride)
            for (std::size_t c = 0; c < 3; ++c)
                image.at(x, y)[c] = magnitude * floatAt(from + 4 * (c % header->channels), header->scale > 0.0);
    return image;
}

std::string encodedPfm(const Image& image)
{
    std::string bytes = "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
    const std::size_t row = 3 * sizeof(float) * static_cast<std::size_t>(image.width);
    for (int y = image.height - 1; y >= 0; --y)
        bytes.append(reinterpret_cast<const char*>(image.at(0, y)), row);
    return bytes;
}

} // namespace reflectance
