// The goniometer of the workbench: it shows what it measures, goes on where it was stopped, and says what went wrong.
#include "app/explorer/lab_study.h"
#include "core/study/goniometer/checkpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

LabWish quick()
{
    LabWish wish;
    wish.surface = "vgrooves:slope=30";
    wish.bounces = 1.0;
    wish.error = 1.0; // of the rms of f: reached by the first batches
    return wish;
}

TEST(LabStudy, ShowsTheRunWhileItGoesAndAtItsEnd)
{
    LabLive live;
    Progress progress;
    int woken = 0;
    const auto outcome = measuredAsWished(
        quick(), nullptr, live, [&] { ++woken; }, progress);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->problem, "");
    EXPECT_GT(woken, 0);
    ASSERT_TRUE(live.latest());
    EXPECT_EQ(live.latest()->paths(), live.latest()->cells.size() * 1024U);
}

TEST(LabStudy, KeepsWhatWasMeasuredWhenStoppedAndGoesOn)
{
    LabLive whole;
    Progress progress;
    ASSERT_TRUE(measuredAsWished(
        quick(), nullptr, whole, [] {}, progress));
    LabLive live;
    Progress stopped;
    EXPECT_FALSE(measuredAsWished(
        quick(), nullptr, live, [&] { stopped.cancel = true; }, stopped));
    ASSERT_TRUE(live.latest());
    Progress again;
    ASSERT_TRUE(measuredAsWished(
        quick(), live.latest(), live, [] {}, again));
    EXPECT_EQ(checkpointText(*live.latest()), checkpointText(*whole.latest()));
}

TEST(LabStudy, GoesOnOnlyWithTheSameSurfaceAndFacets)
{
    LabStudy study;
    EXPECT_FALSE(study.canGoOn());
    study.run = std::make_shared<const LabRun>();
    study.measured = study.wish;
    study.wish.error = 0.5;
    EXPECT_TRUE(study.canGoOn()) << "only how far it goes is another";
    study.wish.bounces = 7.0;
    EXPECT_FALSE(study.canGoOn());
}

TEST(LabStudy, SaysWhatWentWrong)
{
    LabLive live;
    Progress progress;
    LabWish wish = quick();
    wish.surface = "vgrooves:slope=95";
    EXPECT_THAT(measuredAsWished(
                    wish, nullptr, live, [] {}, progress)
                    ->problem,
                testing::HasSubstr("slope = 95"));
    wish = quick();
    wish.model = "mirror";
    EXPECT_THAT(measuredAsWished(
                    wish, nullptr, live, [] {}, progress)
                    ->problem,
                testing::HasSubstr("no BRDF"));
    EXPECT_FALSE(live.latest());
}

} // namespace
} // namespace reflectance::explorer
