// Texts in parts: nothing is lost, no part ends inside a line, a file gives the same parts as a text at hand. And the
// quick way of reading numbers: std::from_chars is the oracle.
#include "core/geometry/plain_numbers.h"
#include "core/geometry/text_parts.h"

#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <unistd.h>

namespace reflectance::testing {
namespace {

std::vector<std::string> partsOf(TextParts text)
{
    std::vector<std::string> parts;
    TextParts::Buffer buffer;
    for (auto part = text.next(buffer); part && !part->empty(); part = text.next(buffer))
        parts.emplace_back(*part);
    return parts;
}

std::string joinedParts(const std::vector<std::string>& parts)
{
    std::string all;
    for (const std::string& part : parts)
        all += part;
    return all;
}

const std::string text = "v 1\nf 2 \\\n3\r\nlong line that is longer than any part\n\rx \\ \r\ny\rz\\w\n# c \\\n\nend";

TEST(TextParts, NothingIsLostAndNoPartEndsInsideALine)
{
    for (std::size_t size = 1; size < text.size(); ++size) {
        const auto parts = partsOf(TextParts(text, size));
        EXPECT_EQ(joinedParts(parts), text);
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            EXPECT_TRUE(parts[i].ends_with('\n') || parts[i].ends_with('\r')) << size;
            EXPECT_FALSE(parts[i].ends_with("\\\n") || parts[i].ends_with("\\ \r\n")) << size;
            EXPECT_FALSE(parts[i].ends_with('\r') && parts[i + 1].starts_with('\n')) << size;
        }
    }
    EXPECT_GE(partsOf(TextParts(text, 8)).size(), 3U) << "and it is cut where it may be";
}

class FileParts : public ::testing::Test {
protected:
    ~FileParts() override { std::filesystem::remove(path_); }
    void write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }

    std::string path_ =
        (std::filesystem::temp_directory_path() / ("parts" + std::to_string(::getpid()) + ".obj")).string();
};

TEST_F(FileParts, AFileGivesWhatATextGives)
{
    write(text);
    for (std::size_t size = 1; size < text.size(); ++size) {
        auto parts = TextParts::ofFile(path_, text.size(), size);
        ASSERT_TRUE(parts);
        EXPECT_EQ(joinedParts(partsOf(*std::move(parts))), text) << size;
    }
}

TEST_F(FileParts, AByteOrderMarkIsLeftOutAndAShortFileIsAnError)
{
    write("\xEF\xBB\xBFv 1\n");
    auto parts = TextParts::ofFile(path_, 7);
    ASSERT_TRUE(parts);
    EXPECT_EQ(joinedParts(partsOf(*std::move(parts))), "v 1\n");
    auto longer = TextParts::ofFile(path_, 100);
    ASSERT_TRUE(longer);
    TextParts::Buffer buffer;
    const auto next = longer->next(buffer);
    ASSERT_FALSE(next);
    EXPECT_EQ(next.error().message, "could not be read to its end");
}

/// Whether the quick way either leaves a number alone or reads it to the same bit and place as std::from_chars.
bool readsAsStandard(const std::string& number, bool& isRead, double (*spoil)(double) = nullptr)
{
    const std::string line = number + " 7\n";
    double expected = 0.0;
    double value = 0.0;
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), expected);
    const char* const behind = plainNumber(line.data(), value);
    isRead = behind != nullptr;
    if (spoil)
        value = spoil(value);
    return !isRead || (behind == stop && error == std::errc{} && std::memcmp(&value, &expected, sizeof value) == 0);
}

TEST(PlainNumbers, AreReadToTheSameBitAsByTheStandardLibrary)
{
    std::mt19937_64 random(7);
    std::size_t read = 0;
    for (int i = 0; i < 200000; ++i) {
        std::string number = random() % 2 == 0 ? "-" : "";
        const std::uint64_t whole = random() % (random() % 3 == 0 ? 1000000000ULL : 10ULL);
        number += std::to_string(whole);
        if (random() % 4 != 0)
            number += "." + std::to_string(random() % (1ULL << (random() % 40 + 1)));
        bool isRead = false;
        ASSERT_TRUE(readsAsStandard(number, isRead)) << number;
        read += isRead ? 1 : 0;
    }
    EXPECT_GT(read, 150000U) << "most of them the quick way";
}

TEST(PlainNumbers, WhatIsNotPlainIsLeftAlone)
{
    bool isRead = true;
    for (const char* number : {"1e5", "nan", "inf", "-", ".5", "5.", "1234567890.1234567", "0x1", "+1", "--1", "1.2.3",
                               "", "123456789012345678901234567890"}) {
        EXPECT_TRUE(readsAsStandard(number, isRead)) << number;
        EXPECT_FALSE(isRead) << number;
    }
    for (const char* number : {"-0", "0", "-0.000000", "007.50", "999999999999999", "0.00000000000001"}) {
        EXPECT_TRUE(readsAsStandard(number, isRead)) << number;
        EXPECT_TRUE(isRead) << number;
    }
}

TEST(PlainNumbers, APlantedLastBitIsCaught)
{
    bool isRead = false;
    EXPECT_FALSE(readsAsStandard("0.3", isRead, [](double x) { return x + 1e-16; }));
}

TEST(PlainNumbers, CornersInAllWritings)
{
    const auto corner = [](const char* line) {
        PlainCorner found;
        const char* const behind = plainCorner(line, found);
        return behind ? std::to_string(found.vertex) + "," + std::to_string(found.normal) : "not plain";
    };
    EXPECT_EQ(corner("12 "), "12,0");
    EXPECT_EQ(corner("12/3\n"), "12,0");
    EXPECT_EQ(corner("12//4\r\n"), "12,4");
    EXPECT_EQ(corner("12/3/4 "), "12,4");
    for (const char* other :
         {"0 ", "-1 ", "1/ ", "1// ", "1/2/ ", "1/2/3/4 ", "1//0 ", "1234567890 ", "x ", "1x ", "\n"})
        EXPECT_EQ(corner(other), "not plain") << other;
}

} // namespace
} // namespace reflectance::testing
