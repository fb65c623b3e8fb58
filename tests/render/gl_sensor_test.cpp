// The sensor pass against core/sensor: the same text, so the same codes.
#include "core/sensor/fields.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <cstdlib>
#include <functional>
#include <glad/gl.h>
#include <utility>

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

    static std::shared_ptr<const ResponseCurve> curveOf(const std::string& csv)
    {
        return std::make_shared<const ResponseCurve>(*parseResponseCurve(csv, "curve.csv"));
    }

    void expectCodesOfTheCore(const Scene& scene, int codesApart, std::string_view what)
    {
        render(scene, settings);
        const Developed expected = develop(renderer().readLinear(), scene.sensor);
        const std::vector<std::uint8_t> got = codes();
        ASSERT_EQ(got.size(), expected.rgb.size());
        std::size_t differing = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            ASSERT_LE(std::abs(got[i] - expected.rgb[i]), codesApart) << what;
            differing += got[i] != expected.rgb[i] ? 1U : 0U;
        }
        // llvmpipe's pow, log and cos are off by 4e-6: 0.001 of a code, so one value in 500 may round the other way.
        EXPECT_LE(differing, got.size() / 500) << what;
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

/// One part of the chain, and how many codes GL's 32 bits may move a value.
struct PartCase {
    const char* assignment;
    int codes;
};

TEST_P(GlSensor, EveryPartGivesTheCodesOfTheCore)
{
    std::string csv;
    for (int i = 0; i <= 200; ++i)
        csv += std::to_string(i) + "," + std::to_string(i * (400 - i)) + "\n";
    for (const auto& [assignment, codesApart] :
         {PartCase{"camera=on:iso=200", 1}, PartCase{"vignetting=cos4:corner=40", 1},
          PartCase{"vignetting=polynomial:polynomial=-0.5,0.2,-0.1", 1}, PartCase{"noise=20:full_well=2000", 1},
          PartCase{"well=0.5", 1}, PartCase{"balance=1.5,1,0.8:matrix=1.2,-0.1,-0.1,-0.2,1.4,-0.2,0,-0.3,1.3", 1},
          PartCase{"response=gamma", 1}, PartCase{"response=off", 1}, PartCase{"encoding=rec709", 1},
          PartCase{"encoding=linear", 1}, PartCase{"quantisation=4", 17}, PartCase{"quantisation=12", 1},
          PartCase{"quantisation=5:dither=on", 9}, PartCase{"quantisation=off", 1}}) {
        Scene scene = twoLightScene("hybrid");
        scene.surface.values["K"] = {0.6, -0.9, 0.0, 0.1, 0.3, 0.1, 0.0, 0.1, 2.0};
        ASSERT_TRUE(setOnSensor(assignment, scene.sensor)) << assignment;
        if (std::string(assignment) == "response=off")
            scene.sensor.response = {true, ResponseKind::Curve, 1.0, "", curveOf(csv)};
        expectCodesOfTheCore(scene, codesApart, assignment);
    }
}

TEST_P(GlSensor, EveryViewGivesTheCodesOfTheCore)
{
    for (const auto& view : sensorViewKinds) {
        Scene scene = twoLightScene("hybrid");
        scene.surface.values["K"] = {0.6, -0.9, 0.0, 0.1, 0.3, 0.1, 0.0, 0.1, 2.0};
        scene.sensor.view = {view.value, true};
        // A false colour's neighbour is another colour altogether: only the share may differ.
        expectCodesOfTheCore(scene, view.value == SensorViewKind::FalseColor ? 255 : 1, view.name);
    }
}

/// All that a picture depends on.
struct Moment {
    Scene scene = twoLightScene("hybrid");
    RenderSettings settings{96, 64, 2};
    GlShading how;
};

/// After a first picture only what changed is drawn, and only pixels that see something are developed anew unless the others
/// change as well.
TEST_P(GlSensor, PicturesAfterTheFirstAreThoseOfANewRenderer)
{
    const auto sensor = [](const char* part) {
        return [part](Moment& m) { ASSERT_TRUE(setOnSensor(part, m.scene.sensor)) << part; };
    };
    const std::vector<std::function<void(Moment&)>> changes{
        [](Moment& m) { m.scene.surface.values["n"] = {3.0}; },
        [](Moment& m) {
            m.scene.background.color = {0.2, 0.5, 0.1};
        },
        [](Moment& m) { m.scene.sensor.exposure = 1.0; },
        [](Moment& m) { m.scene.camera = orbited(m.scene.camera, 0.2, 0.1); },
        [](Moment& m) { m.scene.camera.eye = 1.4 * m.scene.camera.eye; }, // the object becomes smaller
        [](Moment& m) { m.settings.samplesPerAxis = 1; },
        [](Moment& m) { m.scene.lights[0].direction.x += 0.5; },
        [](Moment& m) { m.scene.camera.eye = 1.2 * m.scene.camera.eye; },
        [](Moment& m) { m.scene.camera = orbited(m.scene.camera, -0.3, 0.1); },
        [](Moment& m) { m.how.halfBuffer = true; },
        [](Moment& m) {
            m.scene.background.color = {0.9, 0.1, 0.3};
        },
        [](Moment& m) { m.how.halfBuffer = false; },
        sensor("noise=20"),
        [](Moment& m) { m.scene.lights[0].direction.x -= 0.2; },
        sensor("noise=off"),
        [](Moment& m) { m.settings.samplesPerAxis = 3; },
        sensor("vignetting=cos4:corner=40"),
        [](Moment& m) { m.scene.background.kind = BackgroundKind::Environment; },
        [](Moment& m) { m.scene.environment.kind = EnvironmentKind::Studio; },
        [](Moment& m) { m.settings.samplesPerAxis = 1; },
        [](Moment& m) { m.scene.environment.rotation = 40.0; },
        [](Moment& m) { m.scene.background = {}; },
        sensor("vignetting=off"),
        [](Moment& m) { m.scene.mesh = square(); },
        [](Moment& m) { m.scene.lights[0].direction.x += 0.5; },
    };
    const auto draw = [this](const Moment& m) {
        const auto done = renderer().render(m.scene, m.settings, m.how);
        EXPECT_TRUE(done) << done.error().sentence();
        return std::pair(codes(), renderer().readLinear().rgb);
    };
    std::vector<std::pair<std::vector<std::uint8_t>, std::vector<float>>> drawn;
    Moment moment;
    static_cast<void>(draw(moment));
    for (const auto& change : changes) {
        change(moment);
        drawn.push_back(draw(moment));
    }
    moment = {};
    for (std::size_t step = 0; step < changes.size(); ++step) {
        changes[step](moment);
        startAnew();
        EXPECT_TRUE(draw(moment) == drawn[step]) << "step " << step;
    }
}

/// A surround of one colour is painted by the core's codes, without running the shader there.
TEST_P(GlSensor, PaintsThePlainSurroundInTheCodesOfTheCore)
{
    for (const int samples : {1, 2})
        for (const char* part :
             {"quantisation=8", "quantisation=3", "encoding=rec709", "balance=1.5,1,0.8", "dither=on"}) {
            Scene scene = twoLightScene("hybrid");
            scene.background.color = {0.25, 0.031, 3.0};
            static_cast<void>(setOnSensor(part, scene.sensor));
            render(scene, {96, 64, samples});
            const Developed expected = develop(renderer().readLinear(), scene.sensor);
            const std::vector<std::uint8_t> got = codes();
            for (std::size_t i = 0; i < 3; ++i) // the upper left corner sees nothing
                EXPECT_EQ(got[i], expected.rgb[i]) << part;
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
