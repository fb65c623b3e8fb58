// The judge of measured surfaces must be able to say no; and reading takes memory in proportion to the file.
#include "tests/fuzz/table_readers.h"
#include "tests/measured/made_files.h"

#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace reflectance::fuzz {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string judged(const std::function<void(Table&)>& spoil, std::size_t bytes = 100)
{
    Table table = testing::table("theta_i_deg,theta_r_deg,f_red,f_green,f_blue\n0,0,1,2,3\n0,80,1,2,3\n60,0,1,2,3\n"
                                 "60,80,1,2,3\n");
    spoil(table);
    return brokenPromise(Measurement(std::move(table)), bytes);
}

TEST(TablePromises, AGoodTableKeepsThem)
{
    EXPECT_EQ(judged([](Table&) {}), "");
}

TEST(TablePromises, EveryWrongTableIsNoticed)
{
    EXPECT_NE(judged([](Table& t) { t.axes[0][1] = 0.0; }), "");
    EXPECT_NE(judged([](Table& t) { t.values.pop_back(); }), "");
    EXPECT_NE(judged([](Table& t) { t.values[1] = nan; }), "") << "half a hole";
    EXPECT_NE(judged([](Table& t) { t.values[4] = std::numeric_limits<double>::infinity(); }), "");
    EXPECT_NE(judged([](Table& t) { t.provenance.holes = 5; }), "");
    EXPECT_NE(judged([](Table& t) { t.provenance.name = "a\nb"; }), "");
    EXPECT_NE(judged([](Table&) {}, 1), "") << "a table out of nothing";
}

} // namespace
} // namespace reflectance::fuzz
