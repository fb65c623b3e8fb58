// How long drawing took, by two clocks: no figure is judged but that the clocks are of the same drawing.
#include "core/render/gl/draw_clock.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <chrono>

namespace reflectance::test {
namespace {

class GlClock : public GlTest {
protected:
    /// By the test's own clock, the drawing and all waiting included.
    static double bracketed(const std::function<double()>& clock, double& told)
    {
        const auto start = std::chrono::steady_clock::now();
        told = clock();
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }
};

TEST_P(GlClock, BothClocksTimeWhatIsDrawnBetweenTheirEnds)
{
    const auto functions = GlFunctions::load(context().loader());
    ASSERT_TRUE(functions);
    const Gl& gl = (*functions)->gl();
    const Scene scene = twoLightScene("hybrid");
    int drawings = 0;
    const auto draw = [&] {
        renderer().invalidateSamples();
        render(scene, {256, 256, 2});
        ++drawings;
    };
    draw();
    for (const auto& clock : {wallMillisecondsOf, cardMillisecondsOf}) {
        double told = 0.0;
        const double around = bracketed([&] { return clock(gl, draw); }, told);
        EXPECT_GT(told, 0.0);
        EXPECT_LE(told, around) << "a part of it cannot take longer than the whole";
    }
    EXPECT_EQ(drawings, 3);
}

TEST_P(GlClock, TheRendererTakesTheWallWhereTheProcessorDraws)
{
    ASSERT_TRUE(isSoftware(renderer().description())) << renderer().description();
    double told = 0.0;
    int works = 0;
    const double around = bracketed([&] { return renderer().millisecondsOf([&] { ++works; }); }, told);
    EXPECT_EQ(works, 1);
    EXPECT_GT(told, 0.0);
    EXPECT_LE(told, around);
}

TEST(DrawClock, KnowsSoftwareByItsName)
{
    EXPECT_TRUE(isSoftware("llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5"));
    EXPECT_TRUE(isSoftware("Google SwiftShader"));
    EXPECT_FALSE(isSoftware("NVIDIA H200/PCIe/SSE2, OpenGL 3.3.0"));
    EXPECT_FALSE(isSoftware("AMD Radeon RX 6600 (radeonsi, navi23, LLVM 15.0.6), OpenGL 4.6"));
}

IN_EVERY_CONTEXT(GlClock);

} // namespace
} // namespace reflectance::test
