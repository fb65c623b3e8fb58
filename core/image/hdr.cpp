// Radiance pictures: a header of text lines, a resolution line, then scanlines of RGBE with run lengths.
#include "core/image/formats.h"

#include "core/base/text.h"
#include "core/image/dimensions.h"

#include <array>
#include <cmath>
#include <vector>

namespace reflectance {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// The bytes not yet read. Past the end it gives 0 and remembers.
class Bytes {
public:
    explicit Bytes(std::string_view bytes) : rest_(bytes) {}

    std::uint8_t next()
    {
        if (rest_.empty()) {
            ended_ = true;
            return 0;
        }
        const auto byte = static_cast<std::uint8_t>(rest_.front());
        rest_.remove_prefix(1);
        return byte;
    }

    Rgbe pixel()
    {
        Rgbe value{};
        for (std::uint8_t& byte : value)
            byte = next();
        return value;
    }

    std::string_view line()
    {
        const std::size_t end = rest_.find('\n');
        ended_ = ended_ || end == std::string_view::npos;
        const std::string_view text = rest_.substr(0, end);
        rest_.remove_prefix(std::min(text.size() + 1, rest_.size()));
        return trimmed(text);
    }

    [[nodiscard]] bool ended() const { return ended_; }

private:
    std::string_view rest_;
    bool ended_ = false;
};

/// New run lengths: each of the four components of a line on its own. False where a run leaves the line.
bool readComponents(Bytes& bytes, std::vector<Rgbe>& line)
{
    for (std::size_t component = 0; component < 4; ++component)
        for (std::size_t x = 0; x < line.size();) {
            const std::uint8_t code = bytes.next();
            const bool repeated = code > 128;
            const std::size_t count = repeated ? code - 128U : code;
            if (bytes.ended() || count == 0 || count > line.size() - x)
                return false;
            const std::uint8_t first = bytes.next();
            line[x++][component] = first;
            for (std::size_t i = 1; i < count; ++i)
                line[x++][component] = repeated ? first : bytes.next();
        }
    return !bytes.ended();
}

/// Flat pixels; (1,1,1,k) repeats the one before k times, and 256 k times directly after another repetition.
bool readPixels(Bytes& bytes, std::vector<Rgbe>& line, Rgbe first)
{
    Rgbe previous{};
    unsigned shift = 0;
    std::size_t x = 0;
    for (Rgbe value = first;; value = bytes.pixel()) {
        const bool repetition = value[0] == 1 && value[1] == 1 && value[2] == 1;
        const std::size_t count = repetition ? std::size_t{value[3]} << shift : 1;
        if (bytes.ended() || count > line.size() - x || shift > 16 || (repetition && x == 0))
            return false;
        previous = repetition ? previous : value;
        shift = repetition ? shift + 8 : 0;
        for (std::size_t i = 0; i < count; ++i)
            line[x++] = previous;
        if (x == line.size())
            return true;
    }
}

bool readLine(Bytes& bytes, std::vector<Rgbe>& line)
{
    const Rgbe start = bytes.pixel();
    const bool byComponent =
        start[0] == 2 && start[1] == 2 && start[2] < 128 && line.size() >= 8 && line.size() < 32768;
    if (!byComponent)
        return readPixels(bytes, line, start);
    return 256U * start[2] + start[3] == line.size() && readComponents(bytes, line);
}

/// (m + 1/2) 2^(e - 136)
float radianceOf(std::uint8_t mantissa, std::uint8_t exponent, double exposure)
{
    return exponent == 0 ? 0.0F : static_cast<float>(std::ldexp(mantissa + 0.5, exponent - 136) / exposure);
}

struct HdrHeader {
    long width = 0, height = 0;
    bool upsideDown = false, mirrored = false;
    double exposure = 1.0;
};

/// Nothing where it is not an RGBE picture stored by rows.
std::optional<HdrHeader> readHeader(Bytes& bytes)
{
    HdrHeader header;
    for (std::string_view line = bytes.line(); !line.empty(); line = bytes.line()) {
        if (line.starts_with("FORMAT=") && trimmed(line.substr(7)) != "32-bit_rle_rgbe")
            return std::nullopt;
        if (line.starts_with("EXPOSURE="))
            header.exposure *= parseNumber(trimmed(line.substr(9))).value_or(0.0);
    }
    const auto fields = words(bytes.line());
    if (fields.size() != 4 || !fields[0].ends_with("Y") || !fields[2].ends_with("X") || !(header.exposure > 0.0))
        return std::nullopt;
    header.upsideDown = fields[0] == "+Y";
    header.mirrored = fields[2] == "-X";
    header.height = parseInteger(fields[1]).value_or(0);
    header.width = parseInteger(fields[3]).value_or(0);
    return header;
}

} // namespace

Result<Image> decodedHdr(std::string_view bytes, const std::string& path)
{
    Bytes rest(bytes);
    const auto header = readHeader(rest);
    if (!header)
        return Error{"is not a Radiance picture of RGBE pixels stored by rows (FORMAT=32-bit_rle_rgbe, -Y H +X W)",
                     path};
    // Sixteen bytes of old run lengths can fill a line.
    if (const auto size = checkDimensions(header->width, header->height, bytes.size(), 8192, path); !size)
        return size.error();
    Image image(static_cast<int>(header->width), static_cast<int>(header->height));
    image.coverage.clear();
    std::vector<Rgbe> line(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        if (!readLine(rest, line))
            return Error{"is damaged or cut short in row " + std::to_string(y + 1) + " of its pixels", path};
        for (int x = 0; x < image.width; ++x) {
            const Rgbe& value = line[static_cast<std::size_t>(header->mirrored ? image.width - 1 - x : x)];
            float* rgb = image.at(x, header->upsideDown ? image.height - 1 - y : y);
            for (std::size_t c = 0; c < 3; ++c)
                rgb[c] = radianceOf(value[c], value[3], header->exposure);
        }
    }
    return image;
}

} // namespace reflectance
