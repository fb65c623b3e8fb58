// OpenEXR: our own files bit for bit, and kinds of files that others write.
#include "core/image/formats.h"
#include "tests/image/samples.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <half.h>
#include <sstream>
#include <unistd.h>

namespace reflectance::test {
namespace {

/// The bytes of a file that the library writes: the same half value ramp in every named channel.
std::string made(const Imath::Box2i& window, const std::vector<std::string>& names, Imf::Compression compression,
                 int sampling = 1)
{
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    std::vector<half> values(Image::pixelCount(width, height));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = half(static_cast<float>(i) / 64.0F);
    Imf::Header header(window, window);
    header.compression() = compression;
    Imf::FrameBuffer buffer;
    for (const std::string& name : names) {
        header.channels().insert(name, Imf::Channel(Imf::HALF, sampling, sampling));
        buffer.insert(name, Imf::Slice::Make(Imf::HALF, values.data(), window, sizeof(half),
                                             sizeof(half) * static_cast<std::size_t>(width), sampling, sampling));
    }
    const std::string path = testing::TempDir() + "reflectance_exr_" + std::to_string(::getpid()) + ".exr";
    {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(height);
    }
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    std::filesystem::remove(path);
    return bytes.str();
}

const Imath::Box2i square({0, 0}, {7, 7});

TEST(Exr, ComesBackBitForBitWithCoverage)
{
    const Image image = oddImage(37, 19);
    const auto back = decodedExr(encodedExr(image), "a.exr");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(bitsOf(back->rgb), bitsOf(image.rgb));
    EXPECT_EQ(bitsOf(back->coverage), bitsOf(image.coverage));
}

TEST(Exr, ReversedRowsWouldBeFound)
{
    const Image image = oddImage(37, 19);
    EXPECT_NE(bitsOf(decodedExr(encodedExr(flipped(image)), "a.exr")->rgb), bitsOf(image.rgb));
}

TEST(Exr, WithoutCoverageNoAlphaIsWritten)
{
    Image image = oddImage(3, 3);
    image.coverage.clear();
    const auto back = decodedExr(encodedExr(image), "a.exr");
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->coverage.empty());
}

TEST(Exr, EveryLosslessCompressionGivesTheSameValues)
{
    for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                   Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION}) {
        const auto image = decodedExr(made(square, {"R", "G", "B"}, compression), "a.exr");
        ASSERT_TRUE(image) << image.error().sentence();
        for (std::size_t i = 0; i < image->rgb.size(); ++i)
            EXPECT_EQ(image->rgb[i], static_cast<float>(i / 3) / 64.0F) << compression;
    }
}

TEST(Exr, DwabIsRead)
{
    const auto image = decodedExr(made(square, {"R", "G", "B"}, Imf::DWAB_COMPRESSION), "a.exr");
    ASSERT_TRUE(image) << image.error().sentence();
    for (std::size_t i = 0; i < image->rgb.size(); ++i)
        // Lossy by design: about a percent of the largest value at the standard level of 45.
        EXPECT_NEAR(image->rgb[i], static_cast<float>(i / 3) / 64.0F, 0.02F);
}

TEST(Exr, AnOffsetDataWindowIsThePicture)
{
    const auto image = decodedExr(made({{-3, 5}, {4, 7}}, {"R", "G", "B", "A"}, Imf::ZIP_COMPRESSION), "a.exr");
    ASSERT_TRUE(image) << image.error().sentence();
    EXPECT_EQ(image->width, 8);
    EXPECT_EQ(image->height, 3);
    EXPECT_EQ(image->at(7, 2)[1], 23.0F / 64.0F);
    EXPECT_EQ(image->coverage[23], 23.0F / 64.0F);
}

TEST(Exr, ALoneLuminanceIsGrey)
{
    const auto image = decodedExr(made(square, {"Y"}, Imf::ZIP_COMPRESSION), "a.exr");
    ASSERT_TRUE(image) << image.error().sentence();
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(image->at(1, 1)[c], 9.0F / 64.0F);
}

TEST(Exr, OtherChannelsAreNamedInTheRefusal)
{
    const auto depth = decodedExr(made(square, {"Z", "velocity"}, Imf::ZIP_COMPRESSION), "a.exr");
    ASSERT_FALSE(depth);
    EXPECT_NE(depth.error().message.find("Z, velocity"), std::string::npos) << depth.error().sentence();
    EXPECT_FALSE(decodedExr(made(square, {"Y", "RY", "BY"}, Imf::ZIP_COMPRESSION), "a.exr"));
    EXPECT_FALSE(decodedExr(made(square, {"R", "G", "B"}, Imf::ZIP_COMPRESSION, 2), "a.exr")) << "subsampled";
}

} // namespace
} // namespace reflectance::test
