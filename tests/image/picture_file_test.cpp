// Choosing a format by name or by content, and writing to disk.
#include "core/image/picture_file.h"
#include "tests/image/samples.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace reflectance::test {
namespace {

class PictureFile : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = std::filesystem::path(testing::TempDir()) / ("reflectance_pictures_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

private:
    std::filesystem::path folder_;
};

TEST_F(PictureFile, TheEndingChoosesTheFormatToWrite)
{
    EXPECT_EQ(*outputFormat("a.png"), PictureFormat::Png);
    EXPECT_EQ(*outputFormat("folder.png/a.EXR"), PictureFormat::Exr);
    EXPECT_EQ(*outputFormat("a.b.Pfm"), PictureFormat::Pfm);
    for (const char* name : {"a.hdr", "a.jpg", "a", "png", ""})
        EXPECT_FALSE(outputFormat(name)) << name;
}

TEST_F(PictureFile, TheContentChoosesTheFormatToRead)
{
    const Image image = oddImage(4, 3);
    ASSERT_TRUE(writeLinear(path("a.exr"), image));
    std::filesystem::rename(path("a.exr"), path("misnamed.png"));
    const auto picture = readPicture(path("misnamed.png"));
    ASSERT_TRUE(picture) << picture.error().sentence();
    EXPECT_EQ(picture->format, PictureFormat::Exr);
    EXPECT_TRUE(picture->isLinear());
    EXPECT_EQ(bitsOf(picture->image.rgb), bitsOf(image.rgb));
}

TEST_F(PictureFile, LinearValuesComeBackFromDiskBitForBit)
{
    const Image image = oddImage(64, 33);
    for (const char* name : {"a.exr", "a.pfm"}) {
        ASSERT_TRUE(writeLinear(path(name), image));
        EXPECT_EQ(bitsOf(readPicture(path(name))->image.rgb), bitsOf(image.rgb)) << name;
    }
}

TEST_F(PictureFile, APngIsNotLinear)
{
    ASSERT_TRUE(writePng(path("a.png"), 1, 1, std::array<std::uint8_t, 3>{10, 20, 30}));
    EXPECT_FALSE(readPicture(path("a.png"))->isLinear());
    EXPECT_FALSE(writeLinear(path("b.png"), oddImage(1, 1)));
    EXPECT_FALSE(std::filesystem::exists(path("b.png")));
}

TEST_F(PictureFile, AnUnwritablePlaceIsSaidInASentence)
{
    const auto written = writeLinear(path("missing/a.exr"), oddImage(1, 1));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().file, path("missing/a.exr"));
}

TEST_F(PictureFile, AFileLostOnTheWayWouldBeFound)
{
    ASSERT_TRUE(writeLinear(path("a.pfm"), oddImage(4, 4)));
    std::filesystem::resize_file(path("a.pfm"), 100);
    EXPECT_FALSE(readPicture(path("a.pfm")));
}

} // namespace
} // namespace reflectance::test
