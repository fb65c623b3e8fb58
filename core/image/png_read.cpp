// PNG in, through libpng. Every file is turned into 16-bit RGBA on the way: k/255 equals 257k/65535.
#include "core/image/formats.h"

#include "core/image/dimensions.h"
#include "core/math/srgb.h"

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <png.h>
#include <vector>

namespace reflectance {
namespace {

struct PngReader {
    static constexpr png_byte codePoints[] = {'c', 'I', 'C', 'P', 0};
    std::string_view rest;
    std::string problem;
    png_structp png = nullptr;
    png_infop info = nullptr;

    explicit PngReader(std::string_view bytes) : rest(bytes)
    {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
        info = png_create_info_struct(png);
        png_set_read_fn(png, this, take);
        png_set_user_limits(png, largestSide, largestSide);
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, codePoints, 1);
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

    [[noreturn]] static void fail(png_structp png, png_const_charp message)
    {
        static_cast<PngReader*>(png_get_error_ptr(png))->problem = message;
        png_longjmp(png, 1);
    }
    static void ignore(png_structp, png_const_charp) {}
    static void take(png_structp png, png_bytep to, std::size_t count)
    {
        auto& rest = static_cast<PngReader*>(png_get_io_ptr(png))->rest;
        if (count > rest.size())
            png_error(png, "it ends too early");
        std::memcpy(to, rest.data(), count);
        rest.remove_prefix(count);
    }
};

// libpng reports errors by longjmp: the two functions that can be left so hold no object with a destructor.

bool readInfo(PngReader& reader)
{
    if (setjmp(png_jmpbuf(reader.png)) != 0)
        return false;
    png_read_info(reader.png, reader.info);
    return true;
}

bool readRows(PngReader& reader, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(reader.png)) != 0)
        return false;
    png_set_expand_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 0xffff, PNG_FILLER_AFTER);
    png_set_swap(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

using DecodingTable = std::vector<float>; ///< linear value of each 16-bit code

template <class Decode> DecodingTable tableOf(Decode decode)
{
    DecodingTable table(65536);
    for (std::size_t code = 0; code < table.size(); ++code)
        table[code] = static_cast<float>(decode(static_cast<double>(code) / 65535.0));
    return table;
}

/// Whether a cICP chunk (ITU-T H.273) names the curve of Rec. 709 in full range.
bool saysRec709(png_const_structp png, png_infop info)
{
    png_unknown_chunkp chunks = nullptr;
    const int count = png_get_unknown_chunks(png, info, &chunks);
    return std::any_of(chunks, chunks + count, [](const png_unknown_chunk& chunk) {
        return std::memcmp(chunk.name, PngReader::codePoints, 4) == 0 && chunk.size == 4 && chunk.data[1] == 1 &&
               chunk.data[3] == 1;
    });
}

DecodingTable decodingTable(png_const_structp png, png_infop info)
{
    static const DecodingTable srgb = tableOf(decodeSrgb);
    if (saysRec709(png, info))
        return tableOf(decodeRec709);
    double gamma = 0.0;
    const bool own = png_get_valid(png, info, PNG_INFO_sRGB) == 0 && png_get_gAMA(png, info, &gamma) != 0 &&
                     gamma > 0.0 && std::fabs(gamma - 1.0 / 2.2) > 1e-3;
    return own ? tableOf([gamma](double encoded) { return std::pow(encoded, 1.0 / gamma); }) : srgb;
}

Image linearImage(const std::vector<std::uint16_t>& rgba, int width, int height, const DecodingTable& table)
{
    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            image.rgb[3 * i + c] = table[rgba[4 * i + c]];
        image.coverage[i] = static_cast<float>(rgba[4 * i + 3]) / 65535.0F;
    }
    return image;
}

Notes textsOf(png_const_structp png, png_infop info)
{
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png, info, &texts, &count);
    Notes notes;
    for (int i = 0; i < count; ++i) {
        const png_text& one = texts[i];
        const std::size_t length = one.compression > 0 ? one.itxt_length : one.text_length;
        if (one.key && one.text)
            notes.push_back({one.key, std::string(one.text, length)});
    }
    return notes;
}

} // namespace

Result<Notes> notesOfPng(std::string_view bytes, const std::string& path)
{
    PngReader reader(bytes);
    if (!readInfo(reader))
        return Error{"is a damaged PNG (" + reader.problem + ")", path};
    return textsOf(reader.png, reader.info);
}

Result<Image> decodedPng(std::string_view bytes, const std::string& path)
{
    PngReader reader(bytes);
    if (!readInfo(reader))
        return Error{"is a damaged PNG (" + reader.problem + ")", path};
    const auto width = static_cast<int>(png_get_image_width(reader.png, reader.info));
    const auto height = static_cast<int>(png_get_image_height(reader.png, reader.info));
    // Deflate reaches 1032 to 1, and a pixel may be one bit.
    if (const auto size = checkDimensions(width, height, bytes.size(), 8 * 1032L, path); !size)
        return size.error();
    const bool hasAlpha = (png_get_color_type(reader.png, reader.info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                          png_get_valid(reader.png, reader.info, PNG_INFO_tRNS) != 0;
    const DecodingTable table = decodingTable(reader.png, reader.info);
    std::vector<std::uint16_t> rgba(4 * Image::pixelCount(width, height));
    std::vector<png_bytep> rows(static_cast<std::size_t>(height));
    for (std::size_t y = 0; y < rows.size(); ++y)
        rows[y] = reinterpret_cast<png_bytep>(&rgba[4 * y * static_cast<std::size_t>(width)]);
    if (!readRows(reader, rows.data()))
        return Error{"is a damaged PNG (" + reader.problem + ")", path};
    Image image = linearImage(rgba, width, height, table);
    if (!hasAlpha)
        image.coverage.clear();
    return image;
}

} // namespace reflectance
