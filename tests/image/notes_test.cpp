// Texts that pictures carry: they come back letter by letter, leave the pixels alone, and damage to them is no crash.
#include "core/image/formats.h"

#include <array>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

constexpr std::array<std::uint8_t, 6> codes{1, 2, 3, 250, 251, 252};
const Notes notes{{"Software", "Reflectance Explorer"}, {"reflectance.session", "{\n  \"\u03c3\": 0.7\n}\n"}};

TEST(Notes, ComeBackFromPngAndLeaveThePixelsAlone)
{
    const std::string with = encodedPng(2, 1, codes, {}, notes), without = encodedPng(2, 1, codes);
    const auto read = notesOfPng(with, "a.png");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(*read, notes);
    EXPECT_EQ(decodedPng(with, "a.png")->rgb, decodedPng(without, "a.png")->rgb);
    EXPECT_TRUE(notesOfPng(without, "a.png")->empty());
}

TEST(Notes, ComeBackFromOpenExrAndLeaveThePixelsAlone)
{
    Image image(3, 2);
    image.rgb[4] = 0.3F;
    const std::string with = encodedExr(image, notes);
    const auto read = notesOfExr(with, "a.exr");
    ASSERT_TRUE(read) << read.error().sentence();
    for (const Note& note : notes) {
        const std::string* text = findNote(*read, note.key);
        ASSERT_TRUE(text) << note.key;
        EXPECT_EQ(*text, note.text);
    }
    EXPECT_EQ(decodedExr(with, "a.exr")->rgb, image.rgb);
    EXPECT_FALSE(findNote(*notesOfExr(encodedExr(image), "a.exr"), "reflectance.session"));
}

TEST(Notes, OfManyKilobytesComeBack)
{
    const std::string text(300000, 'x');
    EXPECT_EQ(notesOfPng(encodedPng(2, 1, codes, {}, {{"k", text}}), "a.png")->front().text, text);
    EXPECT_EQ(*findNote(*notesOfExr(encodedExr(Image(1, 1), {{"k", text}}), "a.exr"), "k"), text);
}

TEST(Notes, ADamagedOneIsLeftOutAndADamagedFileIsRefused)
{
    std::string bytes = encodedPng(2, 1, codes, {}, notes);
    const std::size_t at = bytes.find("0.7");
    ASSERT_NE(at, std::string::npos) << "it stands there as it is, for people and their tools";
    bytes[at] = '9'; // the chunk's checksum no longer holds
    const auto read = notesOfPng(bytes, "a.png");
    ASSERT_TRUE(read);
    EXPECT_FALSE(findNote(*read, "reflectance.session"));
    EXPECT_TRUE(findNote(*read, "Software")) << "the planted fault touches one of them only";
    const auto cut = notesOfPng(std::string_view(bytes).substr(0, 40), "a.png");
    ASSERT_FALSE(cut);
    EXPECT_NE(cut.error().sentence().find("a.png: is a damaged PNG"), std::string::npos) << cut.error().sentence();
    EXPECT_FALSE(notesOfExr("\x76\x2f\x31\x01zzz", "a.exr"));
}

} // namespace
} // namespace reflectance
