// An idle window draws nothing.
#include "app/explorer/frame_pace.h"

#include <gtest/gtest.h>

#include <limits>

namespace reflectance::explorer {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// How many frames are drawn before the window sleeps, given that nothing happens.
int framesUntilSleep(FramePace& pace, const Reasons& reasons)
{
    int frames = 0;
    while (pace.secondsToWait(reasons) == 0.0 && frames < 100) {
        pace.waited(false);
        ++frames;
    }
    return frames;
}

TEST(FramePace, SleepsWithoutEndWhenNothingHappens)
{
    FramePace pace;
    const Reasons nothing{.untilRefined = never, .untilPrices = never};
    EXPECT_EQ(framesUntilSleep(pace, nothing), 3);
    EXPECT_EQ(pace.secondsToWait(nothing), never);
    pace.waited(true);
    EXPECT_EQ(framesUntilSleep(pace, nothing), 3);
    EXPECT_EQ(pace.secondsToWait(nothing), never);
}

TEST(FramePace, WakesForTheFirstReason)
{
    FramePace pace;
    framesUntilSleep(pace, {.untilRefined = never, .untilPrices = never});
    EXPECT_DOUBLE_EQ(pace.secondsToWait({.untilRefined = 0.12, .untilPrices = 0.4}), 0.12);
    EXPECT_DOUBLE_EQ(pace.secondsToWait({.untilRefined = never, .untilPrices = 0.4}), 0.4);
    EXPECT_DOUBLE_EQ(pace.secondsToWait({.loading = true, .untilRefined = never, .untilPrices = 0.4}), 0.05);
    EXPECT_EQ(pace.secondsToWait({.untilRefined = -1.0, .untilPrices = never}), 0.0);
}

TEST(FramePace, NeverSleepsWhileTheTableTurns)
{
    FramePace pace;
    const Reasons turning{.animating = true, .untilRefined = never, .untilPrices = never};
    EXPECT_EQ(framesUntilSleep(pace, turning), 100); // planted: the same count tells idle from busy
}

} // namespace
} // namespace reflectance::explorer
