// The price tags of a view: double against itself is exact, the others are as far off as their precision says, and a
// wrong picture shows.
#include "app/explorer/measured_prices.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

DrawnByGl drawnWith(const Scene& scene, Precision precision)
{
    const RenderSettings settings{48, 40, 2};
    DrawnByGl drawn;
    drawn.samples = sampleView(*makeRayScene(scene.mesh), scene.camera, settings);
    drawn.linear = shadeSamples(drawn.samples, scene, precision);
    drawn.milliseconds = 2.5;
    return drawn;
}

TEST(Prices, NameEachPrecisionWithItsError)
{
    const Scene scene = defaultScene();
    Progress progress;
    const std::optional<Prices> prices = measuredPrices(scene, drawnWith(scene, Precision::Float), progress);
    ASSERT_TRUE(prices);
    ASSERT_EQ(prices->tags.size(), 4U);
    EXPECT_EQ(prices->tags[0].name, "double");
    EXPECT_EQ(prices->tags[0].maxError, 0.0);
    EXPECT_EQ(prices->tags[0].worstX, -1);
    for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_GT(prices->tags[i].maxError, 0.0) << prices->tags[i].name;
        // Radiances near 1, n = some tens: float's 6e-8 a few dozen times over.
        EXPECT_LT(prices->tags[i].maxError, 1e-5) << prices->tags[i].name;
        EXPECT_LE(prices->tags[i].rmse, prices->tags[i].maxError) << prices->tags[i].name;
    }
    EXPECT_EQ(prices->tags[3].name, "gl");
    EXPECT_EQ(prices->tags[3].milliseconds, 2.5);
}

TEST(Prices, TimeTheGeneralPathWhereATermWasLeftOut)
{
    Scene scene = defaultScene();
    Progress progress;
    scene.surface.values["ks"] = {0.0};
    EXPECT_GT(measuredPrices(scene, drawnWith(scene, Precision::Float), progress)->tags[2].generalMilliseconds, 0.0);
    scene.surface.values["ks"] = {0.2, 0.3, 0.4}; // K is full and ks a colour: the general form
    EXPECT_EQ(measuredPrices(scene, drawnWith(scene, Precision::Float), progress)->tags[2].generalMilliseconds, 0.0);
}

TEST(Prices, CatchOneWrongPixelOfGl)
{
    const Scene scene = defaultScene();
    DrawnByGl drawn = drawnWith(scene, Precision::Float);
    drawn.linear.at(20, 17)[1] += 0.01F; // planted fault
    drawn.linear.at(21, 17)[0] = -0.5F;
    Progress progress;
    const std::optional<Prices> prices = measuredPrices(scene, drawn, progress);
    ASSERT_TRUE(prices);
    EXPECT_EQ(prices->tags[3].worstX, 21);
    EXPECT_EQ(prices->tags[3].worstY, 17);
    EXPECT_GT(prices->tags[3].maxError, 0.4);
    EXPECT_EQ(prices->counts.negative, 1U);
}

TEST(Prices, GiveUpWhenCancelled)
{
    const Scene scene = defaultScene();
    const DrawnByGl drawn = drawnWith(scene, Precision::Float);
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(measuredPrices(scene, drawn, progress));
}

} // namespace
} // namespace reflectance::explorer
