// Text helpers: parsing is strict, independent of the locale, and exact.
#include "core/base/text.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace reflectance {
namespace {

TEST(Text, TrimsAndSplits)
{
    EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
    EXPECT_EQ(trimmed(" \n"), "");
    EXPECT_EQ(split("a;;b", ';'), (std::vector<std::string_view>{"a", "", "b"}));
    EXPECT_EQ(split("", ';'), (std::vector<std::string_view>{""}));
    EXPECT_EQ(words("  a\t b "), (std::vector<std::string_view>{"a", "b"}));
    EXPECT_TRUE(words(" \t").empty());
}

TEST(Text, NumbersAreTheWholeText)
{
    EXPECT_EQ(parseNumber("1e3"), 1000.0);
    EXPECT_EQ(parseNumber("+0.5"), 0.5);
    EXPECT_EQ(parseNumber("5e-324"), 5e-324);
    EXPECT_EQ(parseNumber("inf"), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(parseNumber("nan").value()));
    for (const char* wrong : {"", "+", "++1", "1x", "1 ", " 1", "0x10", "1,5", "--1", "+-1"})
        EXPECT_FALSE(parseNumber(wrong)) << wrong;
    EXPECT_EQ(parseInteger("-12"), -12);
    EXPECT_FALSE(parseInteger("1.5"));
    EXPECT_FALSE(parseInteger("99999999999999999999"));
}

TEST(Text, ShortestReadsBackToTheSameDouble)
{
    for (const double value : {0.1, 1.0 / 3.0, 1e7, 5e-324, -0.0, 1.7976931348623157e308})
        EXPECT_EQ(parseNumber(shortest(value)), value);
    EXPECT_EQ(shortest(0.1), "0.1");
}

TEST(Text, NearestNameForgivesTyping)
{
    const std::vector<std::string> names{"lambert", "phong", "hybrid"};
    EXPECT_EQ(nearestName("phnog", names), "phong");
    EXPECT_EQ(nearestName("hybird", names), "hybrid");
    EXPECT_EQ(nearestName("", names), "phong"); // the shortest is nearest to nothing
    EXPECT_EQ(nearestName("x", {}), "");
}

TEST(Text, Joins)
{
    EXPECT_EQ(joined({"a", "b"}), "a, b");
    EXPECT_EQ(joined({"", "b"}, "-"), "-b");
    EXPECT_EQ(joined({}), "");
}

} // namespace
} // namespace reflectance
