// Which rungs go together, and what a press in their menu does.
#include "core/scene/rung_list.h"

#include <gmock/gmock.h>
#include <set>

namespace reflectance {
namespace {

using Ids = std::vector<std::string>;

Ids pressed(Ids rungs, const char* id)
{
    return toggledRung(rungs, *rungNamed(id));
}

TEST(RungList, HasEachNameOnce)
{
    std::set<std::string_view> ids;
    for (const RungFacts& rung : rungList)
        EXPECT_TRUE(ids.insert(rung.id).second) << rung.id;
    EXPECT_EQ(rungNamed("duoble"), nullptr);
}

TEST(RungList, APressTakesARungOrGivesItBack)
{
    EXPECT_EQ(pressed({}, "k_diagonal"), Ids{"k_diagonal"});
    EXPECT_EQ(pressed({"k_diagonal"}, "double"), (Ids{"double", "k_diagonal"})) << "in the list's order";
    EXPECT_EQ(pressed({"double", "k_diagonal"}, "k_diagonal"), Ids{"double"});
    EXPECT_EQ(pressed({"double", "k_diagonal"}, "k_grey"), (Ids{"double", "k_grey"})) << "one of an axis";
    EXPECT_EQ(pressed({"glsl", "k_diagonal"}, "per_face"), (Ids{"k_diagonal", "per_face"})) << "GL has no per_face";
}

/// Whatever is pressed in whatever order, the rungs go together.
TEST(RungList, NoPressMakesAContradiction)
{
    Ids rungs;
    unsigned state = 1;
    for (int press = 0; press < 2000; ++press) {
        state = state * 1664525U + 1013904223U;
        rungs = toggledRung(rungs, rungList[(state >> 8U) % std::size(rungList)]);
        ASSERT_TRUE(checkRungs(rungs)) << testing::PrintToString(rungs);
    }
    rungs = {"double", "half_buffer"}; // planted
    EXPECT_FALSE(checkRungs(rungs));
}

TEST(RungList, SaysWhoDraws)
{
    EXPECT_TRUE(drawnByGl(Ids{}, true));
    EXPECT_FALSE(drawnByGl(Ids{"k_grey"}, false)) << "both could";
    EXPECT_TRUE(drawnByGl(Ids{"k_grey", "half_buffer"}, false));
    EXPECT_FALSE(drawnByGl(Ids{"per_vertex"}, true));
}

} // namespace
} // namespace reflectance
