// Lit balls and wedges: pixels are the model's own numbers, strips hold every ball, files are well-formed.
#include "core/reflectance/evaluate.h"
#include "core/study/plots/balls.h"
#include "tests/study/plots/surfaces.h"

#include <cmath>
#include <gmock/gmock.h>

namespace reflectance {
namespace {

using testing::HasSubstr;

BallStrip stripOf(const std::vector<NamedSurface>& surfaces, const Vec3d& L, int size = 33)
{
    Progress progress;
    return *ballsOf(surfaces, {{L, {1.0, 0.5, 2.0}, 0.0}}, Sensor(), size, progress);
}

/// The middle pixel's four samples lie 0.5/33 of the picture's half from N = (0,0,1) in both directions; the ball fills 0.94 of it.
/// 1e-6: float's rounding of four numbers up to 1.6.
TEST(Balls, ShowKdTimesTheCosineTimesTheLight)
{
    const BallStrip strip = stripOf({test::surfaceOf("lambert", {{"kd", {0.8}}})}, {0, 0, 3});
    const float* const middle = strip.balls[0].picture.at(16, 16);
    const double aside = 0.5 / 33 / 0.94;
    const double cosine = std::sqrt(1.0 - 2.0 * aside * aside);
    EXPECT_NEAR(middle[0], 0.8 * cosine, 1e-6); // pictures are float
    EXPECT_NEAR(middle[1], 0.4 * cosine, 1e-6);
    EXPECT_NEAR(middle[2], 1.6 * cosine, 1e-6);
    EXPECT_EQ(strip.balls[0].picture.coverage[0], 0.0F) << "a corner lies beside the ball";
    EXPECT_EQ(strip.balls[0].picture.coverage[33 * 16 + 16], 1.0F);
}

TEST(Balls, AreLitFromWhereTheLightIs)
{
    const BallStrip strip = stripOf({test::surfaceOf("lambert", {})}, {1, 0.5, 0.2});
    const Image& picture = strip.balls[0].picture;
    EXPECT_GT(picture.at(26, 16)[0], picture.at(6, 16)[0]) << "from the right";
    EXPECT_GT(picture.at(16, 7)[0], picture.at(16, 26)[0]) << "from above: row 0 is the top";
    EXPECT_EQ(picture.at(4, 18)[0], 0.0F) << "turned away";
}

/// A pixel's float is the mean of four doubles to float's rounding, 4 units of 2^-24 of numbers up to 1.
TEST(Balls, HoldTheCoresNumbers)
{
    const NamedSurface clay = test::surfaceOf("oren_nayar", {});
    const Vec3d L{0.3, 0.4, 0.8};
    const BallStrip strip = stripOf({clay}, L);
    double sum = 0.0;
    for (const double dx : {0.25, 0.75})
        for (const double dy : {0.25, 0.75}) {
            const auto N = normalAt(2.0 * (20 + dx) / 33 - 1.0, 1.0 - 2.0 * (12 + dy) / 33);
            const Observation row{*N, {0, 0, 1}, {{L, {1.0, 0.5, 2.0}, 0.0}}};
            sum += evaluate(*clay.model, clay.values, {&row, 1}, Precision::Double)[0].x / 4;
        }
    EXPECT_NEAR(strip.balls[0].picture.at(20, 12)[0], sum, 1e-6); // pictures are float
}

TEST(Balls, OfMirrorsShowADisc)
{
    const BallStrip strip = stripOf({test::surfaceOf("mirror", {})}, {0, 0, 1});
    EXPECT_GT(strip.balls[0].picture.at(16, 16)[0], 0.5F);
    EXPECT_EQ(strip.balls[0].picture.at(24, 16)[0], 0.0F);
}

TEST(Balls, StandSideBySideInAStrip)
{
    const BallStrip strip =
        stripOf({test::surfaceOf("lambert", {{"kd", {0.0}}}), test::surfaceOf("lambert", {{"kd", {1.0}}})}, {0, 0, 1});
    const std::vector<std::uint8_t> rgb = developedStrip(strip);
    ASSERT_EQ(rgb.size(), 3U * 66 * 33);
    EXPECT_EQ(rgb[3 * (66 * 16 + 16)], 0);
    EXPECT_EQ(rgb[3 * (66 * 16 + 33 + 16)], 255);
}

TEST(Wedge, RunsOverTheSlidersRange)
{
    const NamedSurface phong = test::surfaceOf("phong", {});
    const Parameter& n = *phong.model->text.find("n");
    const auto wedge = wedgeOf(phong, n, 5);
    ASSERT_EQ(wedge.size(), 5U);
    EXPECT_EQ(wedge.front().values[n.offset], n.sliderMin);
    EXPECT_NEAR(wedge.back().values[n.offset], n.sliderMax, 1e-9 * n.sliderMax);
    EXPECT_NEAR(wedge[2].values[n.offset], 100.0, 1e-9) << "1 .. 10000 on a logarithmic slider";
    EXPECT_EQ(wedge[2].name, "n = 100");
    EXPECT_EQ(wedge[2].values[0], phong.values[0]) << "nothing else changes";
}

/// Brighter with every step of kd, and of no other order: planted, the strip from back to front is not.
TEST(Wedge, OfKdGrowsBrighter)
{
    const NamedSurface lambert = test::surfaceOf("lambert", {});
    BallStrip strip = stripOf(wedgeOf(lambert, *lambert.model->text.find("kd"), 5), {0, 0, 1});
    const auto grows = [&] {
        for (std::size_t i = 1; i < strip.balls.size(); ++i)
            if (!(strip.balls[i].picture.at(16, 16)[0] > strip.balls[i - 1].picture.at(16, 16)[0]))
                return false;
        return true;
    };
    EXPECT_TRUE(grows());
    std::swap(strip.balls[1], strip.balls[3]);
    EXPECT_FALSE(grows());
}

TEST(Wedge, LeavesMatricesAndListsOut)
{
    EXPECT_TRUE(wedgeParameters((*findModel("lambert_color"))->text).empty());
    EXPECT_TRUE(wedgeParameters((*findModel("koenderink"))->text).empty());
    EXPECT_EQ(wedgeParameters((*findModel("hybrid"))->text).size(), 2U);
}

TEST(BallFiles, HoldEveryBall)
{
    const BallStrip strip = stripOf({test::surfaceOf("lambert", {}), test::surfaceOf("phong", {})}, {0, 0, 1}, 9);
    const std::string svg = svgOf(strip, 400, 200);
    EXPECT_THAT(svg, HasSubstr("href=\"data:image/png;base64,iVBORw0KGgo")) << "PNG's signature in base 64";
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    const std::string csv = csvOf(strip);
    EXPECT_TRUE(csv.starts_with("series,x,red,green,blue\nlambert,"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 9);
}

} // namespace
} // namespace reflectance
