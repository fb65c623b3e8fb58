// PNG out, through libpng, into memory.
#include "core/image/formats.h"

#include "core/base/check.h"
#include "core/image/image.h"

#include <png.h>
#include <vector>

namespace reflectance {
namespace {

void append(png_structp png, png_bytep bytes, std::size_t count)
{
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void keepNothing(png_structp) {}

/// Only sizes and memory can fail here, and sizes are checked before.
[[noreturn]] void stop(png_structp, png_const_charp message)
{
    CHECK_EQ(std::string("libpng: ") + message, "no error");
    std::abort();
}

/// libpng copies what it is handed.
void addNotes(png_structp png, png_infop info, const Notes& notes)
{
    std::vector<png_text> texts;
    for (const Note& note : notes) {
        png_text text{};
        text.compression = PNG_ITXT_COMPRESSION_NONE;
        text.key = const_cast<char*>(note.key.c_str());   // NOLINT(*-const-cast): the library's texts are not const
        text.text = const_cast<char*>(note.text.c_str()); // NOLINT(*-const-cast)
        text.itxt_length = note.text.size();
        texts.push_back(text);
    }
    if (!texts.empty())
        png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
}

} // namespace

std::string encodedPng(int width, int height, std::span<const std::uint8_t> rgb, const Notes& notes)
{
    CHECK_LT(0, width);
    CHECK_LT(0, height);
    CHECK_EQ(rgb.size(), 3 * Image::pixelCount(width, height));
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, stop, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, keepNothing);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    addNotes(png, info, notes);
    png_write_info(png, info);
    for (std::size_t at = 0; at < rgb.size(); at += 3 * static_cast<std::size_t>(width))
        png_write_row(png, &rgb[at]);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

} // namespace reflectance
