#include "app/explorer/trade_study.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

TEST(TradeStudy, MeasuresAThirdOfAMegapixelAtMostAndKeepsTheProportion)
{
    EXPECT_EQ(measuredSettings({640, 480, 2}), (RenderSettings{640, 480, 2}));
    const RenderSettings large = measuredSettings({3840, 2160, 3});
    EXPECT_LE(large.width * large.height, 351000); // rounded sides
    EXPECT_NEAR(static_cast<double>(large.width) / large.height, 16.0 / 9.0, 0.01);
    EXPECT_EQ(large.samplesPerAxis, 3);
    EXPECT_EQ(measuredSettings({1, 1, 1}).width, 1);
}

TEST(TradeStudy, IsStaleOnceThePictureDiffers)
{
    const Scene scene = defaultScene();
    Scene changed = scene;
    changed.meshFile = "elsewhere"; // another name for the same mesh
    EXPECT_TRUE(looksTheSame(scene, changed));
    changed.lights[0].direction.x += 1e-9;
    EXPECT_FALSE(looksTheSame(scene, changed)) << "the planted fault";
    changed = scene;
    changed.surface.values["n"] = {41.0};
    EXPECT_FALSE(looksTheSame(scene, changed));
}

TEST(TradeStudy, ShowsTheDialsChoiceUnlessOneIsSelected)
{
    TradeStudy study;
    EXPECT_FALSE(study.shown());
    Trade trade;
    trade.candidates.resize(2);
    trade.candidates[0].error.max = 0.5;
    trade.candidates[0].shade.median = 1.0;
    trade.candidates[1].error.max = 0.01;
    trade.candidates[1].shade.median = 9.0;
    study.trade = std::make_shared<const Trade>(trade);
    study.tolerance = 0.02;
    EXPECT_EQ(study.shown(), std::optional<std::size_t>(1));
    study.byTime = true;
    study.milliseconds = 2.0;
    EXPECT_EQ(study.shown(), std::optional<std::size_t>(0));
    study.selected = 1;
    EXPECT_EQ(study.shown(), std::optional<std::size_t>(1));
    study.selected = 7; // of an earlier, longer run
    EXPECT_EQ(study.shown(), std::optional<std::size_t>(0));
}

} // namespace
} // namespace reflectance::explorer
