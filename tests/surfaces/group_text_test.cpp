// A group's text: what its lines mean, and that whatever is wrong is said with its line.
#include "core/surfaces/group_text.h"

#include <gmock/gmock.h>

namespace reflectance {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* good = "# group  Test\n# model  hybrid\n# source Someone 1999\n# set    n=7\n# scale  K 1 2 4\n"
                             "name, K, extra\n"
                             "One,  0.5, kept as it is\n"
                             "\n"
                             "Two (zoomed), 0.1 0.2 0.3,\n";

Result<std::vector<LibrarySurface>> parsed(const std::string& text)
{
    return parseSurfaceGroup("test", text, "test.csv");
}

TEST(GroupText, ReadsHeadColumnsAndRows)
{
    const auto surfaces = parsed(good);
    ASSERT_TRUE(surfaces) << surfaces.error().sentence();
    ASSERT_EQ(surfaces->size(), 2U);
    const LibrarySurface& one = (*surfaces)[0];
    EXPECT_EQ(one.id, "test/one");
    EXPECT_EQ(one.name, "One");
    EXPECT_EQ(one.group->name, "Test");
    EXPECT_EQ(one.group->source, "Someone 1999");
    EXPECT_THAT(one.values.at("n"), ElementsAre(7.0)) << "set holds for every surface";
    EXPECT_THAT(one.values.at("K"), ElementsAre(0.5, 0, 0, 0, 1.0, 0, 0, 0, 2.0)) << "scaled channel by channel";
    ASSERT_EQ(one.facts.size(), 1U);
    EXPECT_EQ(one.facts[0].name, "extra");
    EXPECT_EQ(one.facts[0].text, "kept as it is");
    EXPECT_EQ((*surfaces)[1].id, "test/two-zoomed");
    EXPECT_THAT((*surfaces)[1].values.at("K"), ElementsAre(0.1, 0, 0, 0, 0.4, 0, 0, 0, 1.2));
    EXPECT_TRUE((*surfaces)[1].facts.empty()) << "an empty cell is no fact";
}

struct Damage {
    const char* found;
    const char* replaced;
    const char* says;
    long line;
};

class DamagedGroup : public testing::TestWithParam<Damage> {};

TEST_P(DamagedGroup, IsRefusedWithItsLine)
{
    std::string text = good;
    const Damage& damage = GetParam();
    const std::size_t at = text.find(damage.found);
    ASSERT_NE(at, std::string::npos) << damage.found;
    text.replace(at, std::string(damage.found).size(), damage.replaced);
    const auto surfaces = parsed(text);
    ASSERT_FALSE(surfaces) << damage.replaced;
    EXPECT_EQ(surfaces.error().file, "test.csv");
    EXPECT_EQ(surfaces.error().line, damage.line);
    EXPECT_THAT(surfaces.error().message, HasSubstr(damage.says));
}

INSTANTIATE_TEST_SUITE_P(
    Table, DamagedGroup,
    testing::Values(Damage{"# source", "# origin", "nothing is known of 'origin'", 3},
                    Damage{"hybrid", "hybird", "did you mean 'hybrid'", 6}, Damage{"n=7", "n=-7", "out of range", 7},
                    Damage{"n=7", "m=7", "has no parameter 'm'", 7}, Damage{"1 2 4", "1 2", "three numbers", 5},
                    Damage{"scale  K", "scale  ks", "no column is called", 6},
                    Damage{"name,", "title,", "no column is called 'name'", 6},
                    Damage{"0.5,", "half,", "no list of numbers for K", 7},
                    Damage{"0.5,", ",", "no list of numbers", 7},
                    Damage{"0.5,", "0.5 0.6,", "takes 1, 3 or 9 numbers", 7}, Damage{"0.5,", "nan,", "is no list of numbers", 7},
                    Damage{"0.5,", "0.5, 1,", "4 cells", 7}, Damage{"One", "  ", "has no name", 7},
                    Damage{"Two (zoomed)", "one", "stands above already", 9}));

} // namespace
} // namespace reflectance
