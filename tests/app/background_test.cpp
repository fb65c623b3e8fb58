// Work on another thread: its value arrives once, cancelled work never does.
#include "app/explorer/background.h"

#include <atomic>
#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

/// Runs until it is cancelled; waits for nothing but that.
std::optional<int> endless(Progress& progress)
{
    progress.done = 0.25;
    while (!progress.cancel)
        std::this_thread::yield();
    return std::nullopt;
}

int valueOf(Background<int>& background)
{
    std::optional<int> value;
    while (!value)
        value = background.take();
    return *value;
}

TEST(Background, HandsItsValueOverOnceAndWakesTheLoop)
{
    std::atomic<int> woken = 0;
    {
        Background<int> background([&] { ++woken; });
        EXPECT_FALSE(background.busy());
        background.start([](Progress&) { return 7; });
        EXPECT_TRUE(background.busy());
        EXPECT_EQ(valueOf(background), 7);
        EXPECT_FALSE(background.busy());
        EXPECT_FALSE(background.take());
    }
    EXPECT_EQ(woken, 1);
}

TEST(Background, ShowsHowFarItIsAndIsGivenUp)
{
    Background<int> background([] {});
    background.start(endless);
    while (background.done() == 0.0)
        std::this_thread::yield();
    EXPECT_EQ(background.done(), 0.25);
    background.cancel();
    EXPECT_FALSE(background.busy());
    EXPECT_FALSE(background.take());
    EXPECT_EQ(background.done(), 0.0);
}

TEST(Background, GivesUpWhatStillRunsForWhatIsWantedNow)
{
    Background<int> background([] {});
    background.start(endless);
    background.start([](Progress&) { return 8; });
    EXPECT_EQ(valueOf(background), 8) << "the planted endless work must not be waited for";
}

TEST(Background, EndsWithItsOwner)
{
    Background<int> background([] {});
    background.start(endless);
}

} // namespace
} // namespace reflectance::explorer
