// Work on another thread: its value arrives once, cancelled work never does.
#include "app/explorer/worker.h"

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

int valueOf(Worker<int>& worker)
{
    std::optional<int> value;
    while (!value)
        value = worker.take();
    return *value;
}

TEST(Worker, HandsItsValueOverOnceAndWakesTheLoop)
{
    std::atomic<int> woken = 0;
    {
        Worker<int> worker([&] { ++woken; });
        EXPECT_FALSE(worker.busy());
        worker.start([](Progress&) { return 7; });
        EXPECT_TRUE(worker.busy());
        EXPECT_EQ(valueOf(worker), 7);
        EXPECT_FALSE(worker.busy());
        EXPECT_FALSE(worker.take());
    }
    EXPECT_EQ(woken, 1);
}

TEST(Worker, ShowsHowFarItIsAndIsGivenUp)
{
    Worker<int> worker([] {});
    worker.start(endless);
    while (worker.done() == 0.0)
        std::this_thread::yield();
    EXPECT_EQ(worker.done(), 0.25);
    worker.cancel();
    EXPECT_FALSE(worker.busy());
    EXPECT_FALSE(worker.take());
    EXPECT_EQ(worker.done(), 0.0);
}

TEST(Worker, GivesUpWhatStillRunsForWhatIsWantedNow)
{
    Worker<int> worker([] {});
    worker.start(endless);
    worker.start([](Progress&) { return 8; });
    EXPECT_EQ(valueOf(worker), 8) << "the planted endless work must not be waited for";
}

TEST(Worker, EndsWithItsOwner)
{
    Worker<int> worker([] {});
    worker.start(endless);
}

} // namespace
} // namespace reflectance::explorer
