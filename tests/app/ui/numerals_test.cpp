#include "app/explorer/ui/numerals.h"

#include <gtest/gtest.h>
#include <limits>

namespace reflectance::explorer {
namespace {

TEST(Numerals, ArePlainInTheMiddleAndPowersAtTheEnds)
{
    EXPECT_EQ(written(0.0, 4), "0");
    EXPECT_EQ(written(0.25, 4), "0.25");
    EXPECT_EQ(written(10000.0, 4), "10000");
    EXPECT_EQ(written(12345.0, 4), "12345");
    EXPECT_EQ(written(1e7, 4), "10\u2077");
    EXPECT_EQ(written(1.9e-6, 2), "1.9\u00D710\u207B\u2076");
    EXPECT_EQ(written(-2.5, 3), "\u22122.5");
    EXPECT_EQ(written(2.5e-12, 3), "2.5\u00D710\u207B\u00B9\u00B2");
}

TEST(Numerals, RoundUpIntoTheNextPower)
{
    EXPECT_EQ(written(9.96e-7, 2), "10\u207B\u2076");
    EXPECT_EQ(written(99999.7, 4), "10\u2075");
}

TEST(Numerals, NameWhatIsNotFinite)
{
    EXPECT_EQ(written(std::numeric_limits<double>::infinity(), 3), "\u221E");
    EXPECT_EQ(written(-std::numeric_limits<double>::infinity(), 3), "\u2212\u221E");
    EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN(), 3), "not a number");
}

TEST(Numerals, GroupThousandsAndScaleTimes)
{
    EXPECT_EQ(grouped(7), "7");
    EXPECT_EQ(grouped(69451), "69\u2009451");
    EXPECT_EQ(grouped(1234567), "1\u2009234\u2009567");
    EXPECT_EQ(duration(0.3412), "0.341 ms");
    EXPECT_EQ(duration(12.34), "12.3 ms");
    EXPECT_EQ(duration(1240.0), "1.24 s");
    EXPECT_EQ(duration(999.7), "1 s");
}

} // namespace
} // namespace reflectance::explorer
