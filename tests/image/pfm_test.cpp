// PFM, against bytes written out here.
#include "core/image/formats.h"
#include "tests/image/samples.h"

#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

// 1.0f is 3f800000, 2.0f is 40000000, 0.5f is 3f000000.
const std::string oneBig("\x3f\x80\0\0", 4);
const std::string twoBig("\x40\0\0\0", 4);
const std::string oneLittle("\0\0\x80\x3f", 4);
const std::string twoLittle("\0\0\0\x40", 4);

std::vector<float> valuesOf(const std::string& bytes)
{
    const auto image = decodedPfm(bytes, "a.pfm");
    return image ? image->rgb : std::vector<float>();
}

TEST(Pfm, ComesBackBitForBit)
{
    const Image image = oddImage(5, 7);
    const auto back = decodedPfm(encodedPfm(image), "a.pfm");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(bitsOf(back->rgb), bitsOf(image.rgb));
    EXPECT_TRUE(back->coverage.empty());
}

TEST(Pfm, ReversedRowsWouldBeFound)
{
    const Image image = oddImage(5, 7);
    EXPECT_NE(bitsOf(decodedPfm(encodedPfm(flipped(image)), "a.pfm")->rgb), bitsOf(image.rgb));
}

TEST(Pfm, TheBottomRowComesFirstInLittleEndian)
{
    Image image(1, 2);
    image.rgb = {1, 1, 1, 2, 2, 2};
    EXPECT_EQ(encodedPfm(image),
              "PF\n1 2\n-1.0\n" + twoLittle + twoLittle + twoLittle + oneLittle + oneLittle + oneLittle);
}

TEST(Pfm, BothByteOrdersAndGreyAreRead)
{
    EXPECT_EQ(valuesOf("Pf\n2 1\n1.0\n" + oneBig + twoBig), (std::vector<float>{1, 1, 1, 2, 2, 2}));
    EXPECT_EQ(valuesOf("Pf 2 1 -1\r" + oneLittle + twoLittle), (std::vector<float>{1, 1, 1, 2, 2, 2}));
    EXPECT_EQ(valuesOf("PF\n1 1\n1\n" + oneBig + twoBig + oneBig), (std::vector<float>{1, 2, 1}));
}

TEST(Pfm, TheScaleMultiplies)
{
    EXPECT_EQ(valuesOf("Pf\n1 1\n-2.5\n" + twoLittle), (std::vector<float>{5, 5, 5}));
}

TEST(Pfm, WrongHeadersAreRefused)
{
    for (const char* header :
         {"PF\n", "PF\n1\n", "PF\n1 1\n", "PF\n1 1\n0\n", "PF\n1 1\nnan\n", "PF\nx 1\n-1\n", "P6\n1 1\n-1\n",
          "PF\n-1 1\n-1\n", "PF\n0 1\n-1\n", "PF\n99999999999 1\n-1\n", "PF\n65536 65536\n-1\n"})
        EXPECT_FALSE(decodedPfm(header + oneLittle + oneLittle + oneLittle, "a.pfm")) << header;
}

} // namespace
} // namespace reflectance::test
