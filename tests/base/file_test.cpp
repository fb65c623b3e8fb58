// Files appear whole or not at all, and only files are read.
#include "core/base/file.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

class File : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::path(testing::TempDir()) / ("reflectance_file_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    [[nodiscard]] long entries() const
    {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }

private:
    fs::path folder_;
};

TEST_F(File, WhatIsWrittenIsReadBackByteForByte)
{
    const std::string bytes("a\0b\r\n\xff", 6);
    ASSERT_TRUE(writeAtomically(path("a"), bytes));
    EXPECT_EQ(*readWholeFile(path("a")), bytes);
    ASSERT_TRUE(writeAtomically(path("a"), ""));
    EXPECT_EQ(*readWholeFile(path("a")), "");
    EXPECT_EQ(entries(), 1) << "the temporary file must be gone";
}

TEST_F(File, AReaderOfTheOldFileKeepsTheOldBytes)
{
    ASSERT_TRUE(writeAtomically(path("a"), "old"));
    std::ifstream open(path("a"));
    ASSERT_TRUE(writeAtomically(path("a"), "new and longer"));
    std::string seen;
    open >> seen;
    EXPECT_EQ(seen, "old") << "the file was overwritten in place";
    EXPECT_EQ(*readWholeFile(path("a")), "new and longer");
}

TEST_F(File, WritingInPlaceWouldBeFound)
{
    ASSERT_TRUE(writeAtomically(path("a"), "old"));
    std::ifstream open(path("a"));
    std::ofstream(path("a")) << "new";
    std::string seen;
    open >> seen;
    EXPECT_EQ(seen, "new");
}

TEST_F(File, AFailedWriteLeavesNothing)
{
    const auto nowhere = writeAtomically(path("missing/a"), "x");
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().file, path("missing/a"));
    EXPECT_NE(nowhere.error().message.find("cannot be written"), std::string::npos);
    ASSERT_FALSE(writeAtomically(path(""), "x")) << "a folder is no file";
    EXPECT_EQ(entries(), 0);
}

TEST_F(File, ALinkIsFollowed)
{
    ASSERT_TRUE(writeAtomically(path("target"), "old"));
    fs::create_symlink(path("target"), path("link"));
    ASSERT_TRUE(writeAtomically(path("link"), "new"));
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(*readWholeFile(path("target")), "new");
}

TEST_F(File, ADeviceIsWrittenAndStaysADevice)
{
    ASSERT_TRUE(writeAtomically("/dev/null", "x"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(File, WhereNothingCanBeWrittenIsKnownBefore)
{
    EXPECT_TRUE(checkWritable(path("new")));
    EXPECT_TRUE(checkWritable("new"));
    EXPECT_TRUE(checkWritable("/dev/null"));
    EXPECT_FALSE(checkWritable(path("missing/new")));
    EXPECT_FALSE(checkWritable(path("")));
    ASSERT_TRUE(writeAtomically(path("file"), "x"));
    EXPECT_TRUE(checkWritable(path("file")));
    EXPECT_FALSE(checkWritable(path("file/new")));
}

TEST_F(File, TheHeadIsReadWithoutTheRest)
{
    ASSERT_TRUE(writeAtomically(path("a"), "head and body"));
    const auto head = readFileHead(path("a"), 4);
    ASSERT_TRUE(head);
    EXPECT_EQ(head->bytes, "head");
    EXPECT_EQ(head->fileSize, 13U);
    EXPECT_EQ(readFileHead(path("a"), 100)->bytes, "head and body");
    EXPECT_FALSE(readFileHead(path("missing"), 4));
    EXPECT_FALSE(readFileHead("/dev/zero", 4));
}

TEST_F(File, OnlyFilesOfBoundedSizeAreRead)
{
    ASSERT_TRUE(writeAtomically(path("a"), "12345"));
    EXPECT_TRUE(readWholeFile(path("a"), 5));
    EXPECT_FALSE(readWholeFile(path("a"), 4));
    EXPECT_FALSE(readWholeFile(path("")));
    EXPECT_FALSE(readWholeFile("/dev/zero"));
    EXPECT_EQ(readWholeFile(path("none")).error().sentence(), path("none") + ": there is no such file");
}

} // namespace
} // namespace reflectance
