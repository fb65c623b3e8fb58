// Files that are cut short, changed in a byte or made of nothing: an Error or an Image, never a crash or gigabytes.
#include "core/image/formats.h"
#include "core/image/picture_file.h"
#include "tests/image/samples.h"

#include <functional>
#include <gtest/gtest.h>
#include <ostream>

namespace reflectance::test {
namespace {

struct Format {
    const char* name;
    std::function<std::string()> whole;

    friend void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }
};

/// 8 x 8 pixels in new run lengths: per component one run of 8.
std::string hdrFile()
{
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 8\n";
    for (int y = 0; y < 8; ++y)
        bytes += std::string("\x02\x02\x00\x08\x88\x40\x88\x50\x88\x60\x88\x80", 12);
    return bytes;
}

std::string pngFile()
{
    std::vector<std::uint8_t> codes(3 * 64);
    for (std::size_t i = 0; i < codes.size(); ++i)
        codes[i] = static_cast<std::uint8_t>(i * 37);
    return encodedPng(8, 8, codes);
}

class Damaged : public testing::TestWithParam<Format> {
protected:
    std::string whole = GetParam().whole();
};

TEST_P(Damaged, TheWholeFileIsRead)
{
    const auto picture = decodedPicture(whole, "whole");
    ASSERT_TRUE(picture) << picture.error().sentence();
    EXPECT_EQ(picture->image.width, 8);
    EXPECT_EQ(picture->image.height, 8);
}

TEST_P(Damaged, EveryShorterFileIsRefusedInASentence)
{
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto picture = decodedPicture(std::string_view(whole).substr(0, length), "cut");
        ASSERT_FALSE(picture) << "cut to " << length << " of " << whole.size() << " bytes";
        EXPECT_EQ(picture.error().file, "cut");
        EXPECT_GT(picture.error().message.size(), 10U);
    }
}

TEST_P(Damaged, AnyChangedByteGivesAnErrorOrAPicture)
{
    std::size_t refused = 0;
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const int change : {0x01, 0x80, 0xff}) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ change);
            const auto picture = decodedPicture(damaged, "damaged");
            if (!picture)
                ++refused;
            else
                // What a changed size can still describe within these few bytes: see dimensions.h.
                EXPECT_LE(picture->image.pixels(), 16384 * whole.size());
        }
    EXPECT_GT(refused, 0U) << "no damage was ever noticed";
}

TEST_P(Damaged, BytesBehindTheEndDoNoHarm)
{
    EXPECT_TRUE(decodedPicture(whole + "more", "longer"));
}

INSTANTIATE_TEST_SUITE_P(Formats, Damaged,
                         testing::Values(Format{"png", pngFile},
                                         Format{"exr", [] { return encodedExr(oddImage(8, 8)); }},
                                         Format{"pfm", [] { return encodedPfm(oddImage(8, 8)); }},
                                         Format{"hdr", hdrFile}),
                         [](const auto& format) { return std::string(format.param.name); });

TEST(DamagedPng, EveryChangedPixelByteIsNoticed)
{
    const std::string whole = pngFile();
    const std::size_t data = whole.find("IDAT") + 4;
    for (std::size_t at = data; at < data + 40; ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        EXPECT_FALSE(decodedPicture(damaged, "damaged.png")) << at;
    }
}

TEST(DamagedPicture, ASmallFileCannotClaimAHugePicture)
{
    EXPECT_FALSE(decodedPicture("PF\n10000 10000\n-1.0\n", "a.pfm"));
    EXPECT_FALSE(decodedPicture("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 10000 +X 10000\n", "a.hdr"));
    std::string png = pngFile();
    // IHDR's width and height; the checksum no longer fits, and the size is refused either way.
    png[16] = 0x40;
    EXPECT_FALSE(decodedPicture(png, "a.png"));
}

TEST(DamagedPicture, OtherFilesAreNoPictures)
{
    for (const char* bytes : {"", "P", "<html>", "%PDF-1.7", "v 0 0 0\n", "GIF89a"}) {
        const auto picture = decodedPicture(bytes, "a");
        ASSERT_FALSE(picture) << bytes;
        EXPECT_NE(picture.error().message.find("not a picture"), std::string::npos);
    }
}

} // namespace
} // namespace reflectance::test
