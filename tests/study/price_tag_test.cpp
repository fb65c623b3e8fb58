#include "core/render/headless/headless_context.h"
#include "core/study/price_tag.h"
#include "tests/render/sphere.h"

#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

constexpr RenderSettings small{64, 64, 2};

TEST(PriceTags, NameEveryArithmeticOfTheCpu)
{
    const auto tags = priceTags(sphereScene("hybrid"), small, nullptr, 1);
    ASSERT_EQ(tags.size(), 3U);
    EXPECT_EQ(tags[0].name, "double");
    EXPECT_EQ(tags[1].name, "float");
    EXPECT_EQ(tags[2].name.substr(0, 6), "simd (");
    for (const PriceTag& tag : tags)
        EXPECT_GT(tag.milliseconds, 0.0);
}

TEST(PriceTags, HoldEachAgainstDouble)
{
    const auto tags = priceTags(sphereScene("hybrid"), small, nullptr, 1);
    EXPECT_EQ(tags[0].maxError, 0.0);
    EXPECT_EQ(tags[0].worstX, -1);
    for (std::size_t i = 1; i < 3; ++i) {
        // Float is neither exact nor worse than its arithmetic: values up to 1, slopes below 5, a few 2^-24.
        EXPECT_GT(tags[i].maxError, 0.0);
        EXPECT_LT(tags[i].maxError, 1e-5);
        EXPECT_GT(tags[i].rmse, 0.0);
        EXPECT_LE(tags[i].rmse, tags[i].maxError);
        EXPECT_GE(tags[i].worstX, 0);
        EXPECT_LT(tags[i].worstY, small.height);
    }
}

TEST(PriceTags, AnEmptyViewHasNoError)
{
    Scene scene = sphereScene("hybrid");
    scene.mesh = std::make_shared<Mesh>();
    for (const PriceTag& tag : priceTags(scene, small, nullptr, 1))
        EXPECT_EQ(tag.rmse, 0.0);
}

/// The planted fault: an exponent whose highlight float cannot hold must cost visibly more than a mild one.
TEST(PriceTags, ShowThatSharpHighlightsAreDearer)
{
    Scene scene = sphereScene("phong", 128);
    scene.surface.values = {{"ks", {1.0}}, {"n", {5.0}}};
    const double mild = priceTags(scene, small, nullptr, 1)[1].maxError;
    // On a picture of 256 pixels a highlight of half-width 67 / sqrt(n) degrees still covers some samples.
    scene.surface.values["n"] = {5000.0};
    EXPECT_GT(priceTags(scene, {256, 256, 1}, nullptr, 1)[1].maxError, 4.0 * mild);
}

TEST(PriceTags, HoldGlAgainstDoubleOnItsOwnSamples)
{
    const auto context = openHeadless(ContextKind::Any);
    ASSERT_TRUE(context) << context.error().sentence();
    auto gl = GlRenderer::create((*context)->loader());
    ASSERT_TRUE(gl) << gl.error().sentence();
    const std::uint64_t before = gl->work().shadings;
    const auto tags = priceTags(sphereScene("hybrid"), small, &*gl, 3);
    ASSERT_EQ(tags.size(), 4U);
    EXPECT_EQ(tags[3].name, "gl");
    EXPECT_GE(gl->work().shadings, before + 4) << "every repetition shades";
    EXPECT_EQ(gl->work().visibilities, 1U) << "and none of them looks again";
    EXPECT_GT(tags[3].milliseconds, 0.0);
    // Coverage is GL's own on both sides, so what remains is float arithmetic: well below one 8-bit code.
    EXPECT_LT(tags[3].maxError, 1e-4);
}

} // namespace
} // namespace reflectance::test
