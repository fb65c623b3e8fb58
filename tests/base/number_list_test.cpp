// Lists of numbers, and the digests that tell contents apart.
#include "core/base/digest.h"
#include "core/base/number_list.h"

#include <gtest/gtest.h>

namespace reflectance {
namespace {

using Numbers = std::optional<std::vector<double>>;

TEST(NumberLists, ArePartedByCommasOrByBlanks)
{
    EXPECT_EQ(numberList("0.25, -3,1e2"), Numbers({0.25, -3.0, 100.0}));
    EXPECT_EQ(numbersInWords(" 0.25\t-3   1e2 "), Numbers({0.25, -3.0, 100.0}));
    EXPECT_EQ(numbersInWords("  "), Numbers(std::vector<double>()));
}

TEST(NumberLists, HoldNothingElse)
{
    for (const char* bad : {"", "1,,2", "1 2", "1, x", "inf", "1, nan", "1,"})
        EXPECT_FALSE(numberList(bad)) << bad;
    for (const char* bad : {"1,2", "1 x", "inf", "1 nan", "1e999"})
        EXPECT_FALSE(numbersInWords(bad)) << bad;
}

/// Published values of the 64-bit FNV-1a function (Fowler, Noll and Vo's own test vectors).
TEST(Digests, AreFnv1a)
{
    EXPECT_EQ(digestOf(""), "cbf29ce484222325");
    EXPECT_EQ(digestOf("a"), "af63dc4c8601ec8c");
    EXPECT_EQ(digestOf("foobar"), "85944171f73967e8");
}

} // namespace
} // namespace reflectance
