// Micro-surfaces have the statistics that their text asks for; what cannot be one is refused in a sentence.
#include "core/base/file.h"
#include "core/image/picture_file.h"
#include "core/study/goniometer/micro_surface.h"
#include "tests/app/scratch_folder.h"
#include "tests/study/goniometer/bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace reflectance {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text)
{
    const auto surface = microSurface(text);
    return surface ? "" : surface.error().sentence();
}

TEST(MicroSurface, GeneratorsHaveTheSlopesAskedFor)
{
    EXPECT_NEAR(microSurface("vgrooves:slope=30")->slope(), std::tan(30 * degree), 1e-12);
    EXPECT_NEAR(microSurface("gaussian:sigma=20")->slope(), std::sqrt(2.0) * std::tan(20 * degree), 1e-9);
    EXPECT_NEAR(microSurface("scratches:sigma=15")->slope(), std::tan(15 * degree), 1e-9);
    // exp(-a^2 / 2 s^2) sin a has the mean square 2 s^2 for small s, up to terms of s^4; 32 quantiles cut its tail a little.
    const double s = 3 * degree;
    EXPECT_NEAR(microSurface("vgrooves:sigma=3")->slope(), std::sqrt(2.0) * s, 0.03 * s);
    EXPECT_EQ(microSurface("flat")->slope(), 0.0);
}

TEST(MicroSurface, GaussianHeightsCorrelateAsAsked)
{
    const MicroSurface surface = *microSurface("gaussian:sigma=20,correlation=0.1,cells=128");
    const auto height = [&](std::size_t x, std::size_t y) {
        return surface.patches[0].positions[(y % 128) * 129 + x % 128].z;
    };
    double mean = 0.0;
    for (std::size_t i = 0; i < 128 * 128; ++i)
        mean += height(i % 128, i / 128) / (128 * 128);
    double alone = 0.0;
    double apart = 0.0;
    for (std::size_t y = 0; y < 128; ++y)
        for (std::size_t x = 0; x < 128; ++x) {
            alone += std::pow(height(x, y) - mean, 2);
            apart += (height(x, y) - mean) * (height(x + 13, y) - mean); // 13 cells are 1.016 correlations
        }
    // exp(-1.03) = 0.357 for endless surfaces; one with some hundred bumps strays by a tenth.
    EXPECT_NEAR(apart / alone, 0.357, 0.15);
}

TEST(MicroSurface, TheSameTextGivesTheSameSurface)
{
    EXPECT_EQ(microSurface("gaussian:cells=64")->fingerprint(), microSurface("gaussian:cells=64")->fingerprint());
    EXPECT_NE(microSurface("gaussian:cells=64")->fingerprint(),
              microSurface("gaussian:cells=64,seed=2")->fingerprint());
    for (const SurfaceKind& kind : surfaceKinds())
        EXPECT_EQ(refusal(kind.initial), "");
}

TEST(MicroSurface, ReadsHeightsFromAPicture)
{
    const explorer::ScratchFolder folder;
    Image image(4, 3);
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 3; ++y)
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] = static_cast<float>(x);
    const std::string file = (folder.path / "ramp.pfm").string();
    ASSERT_TRUE(writeLinear(file, image));
    const MicroSurface wrapped = *microSurface(file + ":height=0.1,tile=wrap");
    EXPECT_EQ(wrapped.patches[0].width, 1.0);
    EXPECT_EQ(wrapped.patches[0].depth, 0.75);
    EXPECT_NEAR(wrapped.patches[0].positions[3].z, 0.3, 1e-12);
    // Half of the mirrored ramp rises by 0.1 per quarter, a cell in eight is level where it turns.
    EXPECT_NEAR(microSurface(file + ":height=0.1")->slope(), 0.4 * std::sqrt(0.75), 1e-9);
    EXPECT_THAT(refusal(file), HasSubstr(":height=H"));
    EXPECT_THAT(refusal(file + ":height=0.1,tile=torn"), HasSubstr("neither mirror nor wrap"));
    EXPECT_THAT(refusal(file + ":height=-1"), HasSubstr("height = -1 is not within"));
}

TEST(MicroSurface, RefusesPicturesThatAreNoHeights)
{
    const explorer::ScratchFolder folder;
    const std::string file = (folder.path / "heights.pfm").string();
    ASSERT_TRUE(writeLinear(file, Image(4, 4)));
    EXPECT_THAT(refusal(file + ":height=1"), HasSubstr("every height is the same"));
    Image torn(4, 4);
    torn.at(2, 1)[0] = std::numeric_limits<float>::quiet_NaN();
    ASSERT_TRUE(writeLinear(file, torn));
    EXPECT_THAT(refusal(file + ":height=1"), HasSubstr("column 2, row 1 is no number"));
    ASSERT_TRUE(writeLinear(file, Image(1100, 1000)));
    EXPECT_THAT(refusal(file + ":height=1,tile=wrap"), HasSubstr("1048576 are possible"));
    ASSERT_TRUE(writeLinear(file, Image(600, 600)));
    EXPECT_THAT(refusal(file + ":height=1"), HasSubstr("heights mirrored"));
    EXPECT_THAT(refusal("missing.png:height=1"), HasSubstr("missing.png"));
}

TEST(MicroSurface, TakesAPatchOfAMeshAndRefusesABody)
{
    const explorer::ScratchFolder folder;
    const std::string patch = (folder.path / "patch.obj").string();
    ASSERT_TRUE(writeAtomically(patch, "v 0 0 0\nv 2 0.1 0\nv 2 0 1\nv 0 0 1\nf 1 2 3\nf 1 3 4\n"));
    const auto surface = microSurface(patch);
    ASSERT_TRUE(surface) << surface.error().sentence();
    EXPECT_EQ(surface->triangles(), 8U);
    EXPECT_NEAR(surface->patches[0].width + surface->patches[0].depth, 1.5, 1e-9);
    EXPECT_THAT(refusal("sphere"), HasSubstr("% of its bounding rectangle open"));
    EXPECT_THAT(refusal("missing.obj"), HasSubstr("missing.obj"));
    EXPECT_THAT(refusal(patch + ":up=w"), HasSubstr("none of x, y and z"));
}

TEST(MicroSurface, RefusesWhatItsTextDoesNotMean)
{
    EXPECT_THAT(refusal("vgrooves"), HasSubstr("vgrooves:slope=30"));
    EXPECT_THAT(refusal("vgrooves:slope=30,sigma=30"), HasSubstr("either one slope or a sigma"));
    EXPECT_THAT(refusal("vgrooves:slope=90"), HasSubstr("slope = 90 is not within"));
    EXPECT_THAT(refusal("gaussian:roughness=2"), HasSubstr("sigma, correlation, cells, seed"));
    EXPECT_THAT(refusal("gaussian:correlation=0.002"), HasSubstr("below two of 256 cells"));
    EXPECT_THAT(refusal("gaussian:sigma=20,sigma=30"), HasSubstr("sigma twice"));
    EXPECT_THAT(refusal("gaussian:sigma=steep"), HasSubstr("sigma = steep"));
    EXPECT_THAT(refusal("flat:height=1"), HasSubstr("write flat alone"));
}

} // namespace
} // namespace reflectance
