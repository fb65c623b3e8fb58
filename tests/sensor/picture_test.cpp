// Pictures as files: what the sensor made comes back as the light that it stands for, whatever the encoding.
#include "core/sensor/picture.h"

#include "core/base/file.h"
#include "core/image/picture_file.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

class SavedPicture : public testing::Test {
protected:
    void SetUp() override
    {
        std::string made = (std::filesystem::temp_directory_path() / "sensorXXXXXX").string();
        ASSERT_NE(mkdtemp(made.data()), nullptr);
        folder = made;
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    [[nodiscard]] std::string path(const char* name) const { return (folder / name).string(); }

    /// The largest difference after a picture was saved as PNG and read again.
    [[nodiscard]] double lost(const Sensor& sensor) const
    {
        Image image(64, 16);
        for (std::size_t i = 0; i < image.rgb.size(); ++i)
            image.rgb[i] = static_cast<float>(i) / static_cast<float>(image.rgb.size() - 1);
        EXPECT_TRUE(savePicture(path("a.png"), image, sensor));
        const auto read = readPicture(path("a.png"));
        EXPECT_TRUE(read) << read.error().sentence();
        double largest = 0.0;
        for (std::size_t i = 0; read && i < image.rgb.size(); ++i)
            largest = std::max(largest, std::fabs(double{read->image.rgb[i]} - double{image.rgb[i]}));
        return largest;
    }

    std::filesystem::path folder;
};

TEST_F(SavedPicture, EveryEncodingComesBackAsLight)
{
    Sensor sensor;
    sensor.quantisation.bits = 16;
    // Half a step of 16 bits times the steepest slope from code to light: 2.3 (sRGB), 2.2 (Rec. 709), 1 (linear); in front of
    // it float's rounding, 6e-8.
    EXPECT_LT(lost(sensor), 2.3 * 0.5 / 65535.0 + 1e-7);
    sensor.encoding.kind = EncodingKind::Rec709;
    EXPECT_LT(lost(sensor), 2.3 * 0.5 / 65535.0 + 1e-7);
    sensor.encoding.kind = EncodingKind::Linear;
    EXPECT_LT(lost(sensor), 0.5 / 65535.0 + 1e-7);
    sensor.response.on = true;
    sensor.response.gamma = 1.8;
    // A gAMA chunk has five digits: 1/1.8 is 1e-5 off, times x ln x <= 0.37 and 1.8.
    EXPECT_LT(lost(sensor), 1.8 * 0.5 / 65535.0 + 1e-5);
}

TEST_F(SavedPicture, WouldNoticeTheWrongChunk)
{
    Sensor sensor;
    sensor.encoding.kind = EncodingKind::Rec709;
    const double right = lost(sensor);
    Image image(1, 1);
    image.rgb = {0.18F, 0.18F, 0.18F};
    // The same codes, said to be sRGB.
    ASSERT_TRUE(writePng(path("b.png"), 1, 1, develop(image, sensor).rgb));
    EXPECT_GT(std::fabs(double{readPicture(path("b.png"))->image.rgb[0]} - 0.18), 5.0 * right);
}

TEST_F(SavedPicture, HasSixteenBitsOnlyWhereTheSensorHasMoreThanEight)
{
    const Image image(4, 4);
    for (const auto& [bits, on, depth] :
         {std::tuple{8, true, 8}, {1, true, 8}, {9, true, 16}, {16, true, 16}, {8, false, 16}}) {
        Sensor sensor;
        sensor.quantisation = {on, bits, false};
        ASSERT_TRUE(savePicture(path("a.png"), image, sensor));
        EXPECT_EQ((*readWholeFile(path("a.png")))[24], depth); // of the header
    }
}

TEST_F(SavedPicture, SaysHowItIsEncoded)
{
    const Image image(2, 2);
    const auto has = [&](EncodingKind kind, const char* chunk) {
        Sensor sensor;
        sensor.encoding.kind = kind;
        EXPECT_TRUE(savePicture(path("a.png"), image, sensor));
        return readWholeFile(path("a.png"))->find(chunk) != std::string::npos;
    };
    EXPECT_TRUE(has(EncodingKind::Srgb, "sRGB"));
    EXPECT_FALSE(has(EncodingKind::Srgb, "cICP"));
    EXPECT_TRUE(has(EncodingKind::Rec709, "cICP"));
    EXPECT_FALSE(has(EncodingKind::Rec709, "sRGB"));
    EXPECT_TRUE(has(EncodingKind::Rec709, "cHRM"));
    EXPECT_TRUE(has(EncodingKind::Linear, "gAMA"));
    EXPECT_TRUE(has(EncodingKind::Linear, "cHRM"));
    EXPECT_FALSE(has(EncodingKind::Linear, "sRGB"));
}

TEST_F(SavedPicture, AnExrNamesItsPrimaries)
{
    ASSERT_TRUE(savePicture(path("a.exr"), Image(2, 2), Sensor()));
    EXPECT_NE(readWholeFile(path("a.exr"))->find("chromaticities"), std::string::npos);
}

} // namespace
} // namespace reflectance
