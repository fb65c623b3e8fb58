// What the first picture took is said in stages, once. How long is nobody's promise here.
#include "app/explorer/start_clock.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(StartClock, TellsItsStagesOnceThePictureIsShown)
{
    StartClock clock;
    clock.note("window");
    EXPECT_FALSE(clock.done());
    EXPECT_EQ(clock.sentence(), "");
    clock.note("shown");
    EXPECT_TRUE(clock.done());
    EXPECT_THAT(clock.sentence(), testing::MatchesRegex("First picture after [0-9.e-]+ s\\."));
    EXPECT_THAT(clock.report(), testing::AllOf(HasSubstr("of processors)  window\n"), HasSubstr("of processors)  shown\n")));
    const std::string before = clock.report();
    clock.note("later"); // planted: would be counted
    EXPECT_EQ(clock.report(), before);
    EXPECT_THAT(before, Not(HasSubstr("later")));
}

} // namespace
} // namespace reflectance::explorer
