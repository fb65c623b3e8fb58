// The sensor pass against core/sensor: the same text, so the same codes.
#include "core/sensor/sensor.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <cstdlib>
#include <glad/gl.h>

namespace reflectance::test {
namespace {

constexpr RenderSettings settings{96, 64, 2};

class GlSensor : public GlTest {
protected:
    /// The developed texture's colours, rows from the top as core/sensor has them.
    std::vector<std::uint8_t> codes()
    {
        GladGLContext gl{};
        EXPECT_NE(gladLoadGLContext(&gl, context().loader()), 0);
        std::vector<std::uint8_t> rgba(std::size_t{4} * 96 * 64);
        gl.BindTexture(GL_TEXTURE_2D, renderer().developedTexture());
        gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        std::vector<std::uint8_t> rgb;
        for (std::size_t y = 64; y-- > 0;)
            for (std::size_t x = 0; x < 96; ++x) {
                const std::uint8_t* code = &rgba[4 * (y * 96 + x)];
                EXPECT_EQ(code[3], 255) << "opaque";
                rgb.insert(rgb.end(), code, code + 3);
            }
        return rgb;
    }
};

TEST_P(GlSensor, GivesTheCodesOfTheCore)
{
    Scene scene = twoLightScene("hybrid");
    scene.surface.values["K"] = {0.6, -0.9, 0.0, 0.1, 0.3, 0.1, 0.0, 0.1, 2.0}; // negative and clipped pixels too
    for (const double exposure : {0.0, -3.0, 2.0}) {
        scene.sensor.exposure = exposure;
        render(scene, settings);
        const Developed expected = develop(renderer().readLinear(), scene.sensor);
        EXPECT_EQ(expected.counts.clipped > 0U, exposure >= 0.0);
        EXPECT_GT(expected.counts.negative, 0U);
        const std::vector<std::uint8_t> got = codes();
        ASSERT_EQ(got.size(), expected.rgb.size());
        std::size_t differing = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            // llvmpipe's pow is off by 4e-6: 0.001 of a code, so one value in 500 may round the other way.
            EXPECT_LE(std::abs(got[i] - expected.rgb[i]), 1);
            differing += got[i] != expected.rgb[i] ? 1U : 0U;
        }
        EXPECT_LE(differing, got.size() / 500) << exposure;
    }
}

TEST_P(GlSensor, NoticesAnotherExposure)
{
    Scene scene = twoLightScene("hybrid");
    render(scene, settings);
    Sensor other;
    other.exposure = 0.1;
    EXPECT_NE(codes(), develop(renderer().readLinear(), other).rgb) << "the planted fault";
}

IN_EVERY_CONTEXT(GlSensor);

} // namespace
} // namespace reflectance::test
