// What GL may give up when asked: one shading per pixel, and a linear picture in 16-bit floats.
#include "core/render/cpu/shading_places.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <algorithm>
#include <cmath>

namespace reflectance::test {
namespace {

constexpr RenderSettings settings{64, 48, 3};

double largestDifference(const Image& a, const Image& b)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        worst = std::max(worst, std::fabs(static_cast<double>(a.rgb[i]) - static_cast<double>(b.rgb[i])));
    return worst;
}

class GlShadingTest : public GlTest {
protected:
    Image drawn(const Scene& scene, const GlShading& how)
    {
        const auto done = renderer().render(scene, settings, how);
        EXPECT_TRUE(done) << done.error().sentence();
        return renderer().readLinear();
    }
};

TEST_P(GlShadingTest, OncePerPixelOrFragmentIsWhatTheCpuMakesOfTheSameSamples)
{
    const Scene scene = twoLightScene("hybrid");
    for (const Place place : {Place::Pixel, Place::Fragment}) {
        const Image once = drawn(scene, {place, false});
        const auto samples = std::make_shared<const ViewSamples>(renderer().readSamples());
        const Image same = shadePlaces(placedView(samples, *scene.mesh, place), scene, Precision::Double);
        // Float against double on equal samples: (16 + 9 sqrt(40)) 2^-24 of lights up to 1.5, see gl_picture_test.cpp.
        EXPECT_LE(largestDifference(once, same), 1e-5) << nameOf(place);
        EXPECT_EQ(once.coverage, same.coverage) << "coverage comes from every sample";
        EXPECT_GT(largestDifference(drawn(scene, {}), once), 1e-3)
            << nameOf(place) << ", the planted fault: every sample differs from one";
    }
}

TEST_P(GlShadingTest, HalfBufferKeepsElevenBits)
{
    const Scene scene = twoLightScene("hybrid");
    const Image whole = drawn(scene, {});
    const Image half = drawn(scene, {Place::Sample, true});
    const float brightest = *std::max_element(whole.rgb.begin(), whole.rgb.end());
    const double off = largestDifference(whole, half);
    EXPECT_GT(off, 0.0);
    // Rounded to nearest 2^-11, or cut to 2^-10, of the value: GL leaves the choice to the driver.
    EXPECT_LE(off, 0x1p-10 * static_cast<double>(brightest));
    EXPECT_EQ(largestDifference(drawn(scene, {}), whole), 0.0) << "and the way back leads to the same picture";
}

TEST_P(GlShadingTest, LooksAgainOnlyWhenAsked)
{
    const Scene scene = twoLightScene("lambert");
    drawn(scene, {});
    const auto before = renderer().work().visibilities;
    drawn(scene, {Place::Pixel, true});
    EXPECT_EQ(renderer().work().visibilities, before);
    renderer().invalidateSamples();
    drawn(scene, {Place::Pixel, true});
    EXPECT_EQ(renderer().work().visibilities, before + 1);
}

IN_EVERY_CONTEXT(GlShadingTest);

} // namespace
} // namespace reflectance::test
