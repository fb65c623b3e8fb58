// Radiance pictures, against bytes written out here.
#include "core/image/formats.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

std::string header(const std::string& resolution, const std::string& more = "")
{
    return "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n" + more + "\n" + resolution + "\n";
}

std::string pixel(int r, int g, int b, int e)
{
    std::string bytes;
    for (const int byte : {r, g, b, e})
        bytes.push_back(static_cast<char>(byte));
    return bytes;
}

std::vector<float> valuesOf(const std::string& bytes)
{
    const auto image = decodedHdr(bytes, "a.hdr");
    return image ? image->rgb : std::vector<float>();
}

/// Red of each pixel in a picture of one row.
std::vector<float> redsOf(const std::string& bytes)
{
    std::vector<float> reds;
    const std::vector<float> rgb = valuesOf(bytes);
    for (std::size_t i = 0; i < rgb.size(); i += 3)
        reds.push_back(rgb[i]);
    return reds;
}

constexpr float half = 0.5F / 256.0F;

TEST(Hdr, AMantissaStandsForTheMiddleOfItsInterval)
{
    // e = 128 is 2^0 over 256 steps.
    EXPECT_EQ(valuesOf(header("-Y 1 +X 1") + pixel(128, 64, 0, 128)),
              (std::vector<float>{0.5F + half, 0.25F + half, half}));
    EXPECT_EQ(valuesOf(header("-Y 1 +X 1") + pixel(255, 1, 0, 138)), (std::vector<float>{1022.0F, 6.0F, 2.0F}));
}

TEST(Hdr, TheOlderConventionWithoutTheHalfWouldBeFound)
{
    EXPECT_NE(valuesOf(header("-Y 1 +X 1") + pixel(128, 64, 0, 128)), (std::vector<float>{0.5F, 0.25F, 0.0F}));
}

TEST(Hdr, AnExponentOfZeroIsBlack)
{
    EXPECT_EQ(valuesOf(header("-Y 1 +X 1") + pixel(200, 100, 50, 0)), (std::vector<float>{0, 0, 0}));
}

TEST(Hdr, TheExtremesOfTheExponentAreKept)
{
    const std::vector<float> values = valuesOf(header("-Y 1 +X 1") + pixel(255, 255, 255, 255));
    EXPECT_EQ(values[0], std::ldexp(255.5F, 119));
    EXPECT_EQ(valuesOf(header("-Y 1 +X 1") + pixel(1, 1, 2, 1))[0], std::ldexp(1.5F, -135));
}

TEST(Hdr, NewRunLengths)
{
    // Eight pixels; red: a run of 8; green: 8 plain bytes; blue: a run of 5 and 3 plain; exponent: a run of 8.
    const std::string line = pixel(2, 2, 0, 8) + "\x88\x40" + std::string("\x08\0\x10\x20\x30\x40\x50\x60\x70", 9) +
                             "\x85\x20" + "\x03\x01\x02\x03" + "\x88\x80";
    const std::vector<float> values = valuesOf(header("-Y 1 +X 8") + line);
    ASSERT_EQ(values.size(), 24U);
    for (std::size_t x = 0; x < 8; ++x) {
        EXPECT_EQ(values[3 * x], 0.25F + half);
        EXPECT_EQ(values[3 * x + 1], static_cast<float>(x) / 16.0F + half);
        EXPECT_EQ(values[3 * x + 2], (x < 5 ? 32.0F : static_cast<float>(x - 4)) / 256.0F + half);
    }
}

TEST(Hdr, OldRunLengths)
{
    // One pixel, repeated three times; then another.
    const std::string line = pixel(128, 0, 0, 128) + pixel(1, 1, 1, 3) + pixel(64, 0, 0, 128);
    EXPECT_EQ(redsOf(header("-Y 1 +X 5") + line),
              (std::vector<float>{0.5F + half, 0.5F + half, 0.5F + half, 0.5F + half, 0.25F + half}));
    // Two repetitions in a row: 4 + 256 * 1.
    const std::string twice = pixel(128, 0, 0, 128) + pixel(1, 1, 1, 4) + pixel(1, 1, 1, 1);
    EXPECT_EQ(redsOf(header("-Y 1 +X 261") + twice), std::vector<float>(261, 0.5F + half));
}

TEST(Hdr, RowsAndColumnsMayRunBackwards)
{
    const std::string pixels =
        pixel(0, 0, 0, 128) + pixel(64, 0, 0, 128) + pixel(128, 0, 0, 128) + pixel(192, 0, 0, 128);
    const float a = half;
    const float b = 0.25F + half;
    const float c = 0.5F + half;
    const float d = 0.75F + half;
    EXPECT_EQ(redsOf(header("-Y 2 +X 2") + pixels), (std::vector<float>{a, b, c, d}));
    EXPECT_EQ(redsOf(header("+Y 2 +X 2") + pixels), (std::vector<float>{c, d, a, b}));
    EXPECT_EQ(redsOf(header("-Y 2 -X 2") + pixels), (std::vector<float>{b, a, d, c}));
}

TEST(Hdr, ExposureIsDividedOut)
{
    EXPECT_EQ(redsOf(header("-Y 1 +X 1", "EXPOSURE=2\nEXPOSURE= 0.5\nEXPOSURE=4\n") + pixel(128, 0, 0, 128))[0],
              (0.5F + half) / 4.0F);
}

TEST(Hdr, WhatIsNotUnderstoodIsRefused)
{
    const std::string white = pixel(128, 128, 128, 128);
    EXPECT_FALSE(decodedHdr("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + white, "a.hdr"));
    EXPECT_FALSE(decodedHdr(header("+X 1 -Y 1") + white, "a.hdr"));
    EXPECT_FALSE(decodedHdr(header("-Y 1 +X 1", "EXPOSURE=0\n") + white, "a.hdr"));
    EXPECT_FALSE(decodedHdr(header("-Y 0 +X 1") + white, "a.hdr"));
    EXPECT_FALSE(decodedHdr(header("-Y 9999999 +X 9999999") + white, "a.hdr"));
    EXPECT_FALSE(decodedHdr(header("-Y 1 +X 2") + white, "a.hdr"));
    EXPECT_FALSE(decodedHdr(header("-Y 1 +X 2") + pixel(1, 1, 1, 2) + white, "a.hdr")) << "repeats what never was";
    EXPECT_FALSE(decodedHdr(header("-Y 1 +X 2") + white + pixel(1, 1, 1, 5), "a.hdr")) << "runs past the line's end";
    EXPECT_FALSE(decodedHdr(header("-Y 1 +X 8") + pixel(2, 2, 0, 8) + "\x89\x40", "a.hdr"))
        << "runs past the line's end";
}

} // namespace
} // namespace reflectance::test
