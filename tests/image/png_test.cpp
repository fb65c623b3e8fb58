// PNG: our own files code for code, and every colour type that others write.
#include "core/image/formats.h"
#include "core/math/srgb.h"
#include "tests/image/samples.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <png.h>

namespace reflectance::test {
namespace {

struct Recipe {
    int colorType = PNG_COLOR_TYPE_RGB;
    int depth = 8;
    double gamma = 0.0; ///< of a gAMA chunk; 0: none
    bool interlaced = false;
};

void append(png_structp png, png_bytep bytes, std::size_t count)
{
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// A PNG of one row with the given bytes, 16-bit samples high byte first.
std::string made(const Recipe& recipe, int width, std::vector<std::uint8_t> row)
{
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), 1, recipe.depth, recipe.colorType,
                 recipe.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    const std::array<png_color, 2> palette{{{10, 20, 30}, {200, 100, 50}}};
    if (recipe.colorType == PNG_COLOR_TYPE_PALETTE)
        png_set_PLTE(png, info, palette.data(), 2);
    if (recipe.gamma > 0.0)
        png_set_gAMA(png, info, recipe.gamma);
    png_write_info(png, info);
    png_bytep rows = row.data();
    png_write_image(png, &rows);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

/// All code values in one channel each, and their mixture, so that channels and columns cannot be swapped unseen.
std::vector<std::uint8_t> allCodes()
{
    std::vector<std::uint8_t> rgb;
    for (int code = 0; code < 256; ++code)
        for (const int value : {code, 255 - code, code * 7 % 256})
            rgb.push_back(static_cast<std::uint8_t>(value));
    return rgb;
}

float linear(double code)
{
    return static_cast<float>(decodeSrgb(code / 255.0));
}

TEST(Png, WrittenCodesComeBackAsTheirLinearValues)
{
    const std::vector<std::uint8_t> codes = allCodes();
    const auto image = decodedPng(encodedPng(16, 16, codes), "a.png");
    ASSERT_TRUE(image) << image.error().sentence();
    ASSERT_EQ(image->rgb.size(), codes.size());
    for (std::size_t i = 0; i < codes.size(); ++i)
        EXPECT_EQ(image->rgb[i], linear(codes[i]));
    EXPECT_TRUE(image->coverage.empty());
}

TEST(Png, CodesTakenForLinearWouldBeFound)
{
    const auto image = decodedPng(encodedPng(16, 16, allCodes()), "a.png");
    EXPECT_GT(std::fabs(image->rgb[3 * 128] - 128.0F / 255.0F), 0.2F);
}

TEST(Png, SaysThatItIsSrgb)
{
    const std::string bytes = encodedPng(1, 1, std::array<std::uint8_t, 3>{1, 2, 3});
    EXPECT_NE(bytes.find("sRGB"), std::string::npos);
    EXPECT_NE(bytes.find("gAMA"), std::string::npos);
}

TEST(Png, EveryColourTypeIsRead)
{
    const auto rgbOf = [](const Recipe& recipe, int width, const std::vector<std::uint8_t>& row) {
        const auto image = decodedPng(made(recipe, width, row), "a.png");
        return image ? image->rgb : std::vector<float>();
    };
    const std::vector<float> greys{linear(0), linear(0), linear(0), linear(200), linear(200), linear(200)};
    EXPECT_EQ(rgbOf({PNG_COLOR_TYPE_GRAY, 8}, 2, {0, 200}), greys);
    EXPECT_EQ(rgbOf({PNG_COLOR_TYPE_GRAY, 8, 0.0, true}, 2, {0, 200}), greys);
    EXPECT_EQ(rgbOf({PNG_COLOR_TYPE_GRAY, 16}, 2, {0, 0, 200, 200}), greys);
    EXPECT_EQ(rgbOf({PNG_COLOR_TYPE_GRAY, 1}, 2, {0x40}), (std::vector<float>{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(rgbOf({PNG_COLOR_TYPE_PALETTE, 8}, 2, {1, 0}),
              (std::vector<float>{linear(200), linear(100), linear(50), linear(10), linear(20), linear(30)}));
    EXPECT_EQ(rgbOf({PNG_COLOR_TYPE_RGB, 16}, 1, {0x80, 0x01, 0xff, 0xff, 0, 0}),
              (std::vector<float>{linear(0x8001 / 257.0), 1, 0}));
}

TEST(Png, AlphaBecomesCoverageAndLeavesColoursAlone)
{
    const auto image = decodedPng(made({PNG_COLOR_TYPE_RGB_ALPHA, 8}, 1, {200, 100, 50, 51}), "a.png");
    ASSERT_TRUE(image) << image.error().sentence();
    EXPECT_EQ(image->rgb, (std::vector<float>{linear(200), linear(100), linear(50)}));
    EXPECT_EQ(image->coverage, std::vector<float>{0.2F});
}

TEST(Png, AFilesOwnGammaIsHonoured)
{
    const auto read = [](double gamma) {
        return decodedPng(made({PNG_COLOR_TYPE_GRAY, 8, gamma}, 1, {128}), "a.png")->rgb[0];
    };
    EXPECT_EQ(read(1.0), 128.0F / 255.0F);
    // gAMA is stored in steps of 1e-5.
    EXPECT_NEAR(read(0.5), std::pow(128.0F / 255.0F, 2.0F), 1e-5);
    EXPECT_EQ(read(0.45455), linear(128)) << "1/2.2 stands for sRGB";
}

} // namespace
} // namespace reflectance::test
