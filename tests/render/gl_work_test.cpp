// Only the passes whose inputs changed run again: the renderer counts its own work.
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <algorithm>
#include <array>
#include <functional>

namespace reflectance::test {
namespace {

constexpr RenderSettings small{64, 48, 2};

/// Mesh uploads, visibilities, shadings, developments, links, allocations, table uploads.
using Figures = std::array<std::uint64_t, 7>;

Figures figures(const GlWork& w)
{
    return {w.meshUploads, w.visibilities, w.shadings, w.developments, w.programLinks, w.allocations, w.tableUploads};
}

struct Change {
    const char* name;
    std::function<void(Scene&)> make;
    Figures work; ///< expected on top of the first picture's
};

class GlWorkCounts : public GlTest {
protected:
    /// The work that this change causes after a first picture.
    Figures workOf(const Change& change, RenderSettings settings = small)
    {
        Scene scene = twoLightScene("hybrid");
        render(scene, small);
        const Figures before = figures(renderer().work());
        change.make(scene);
        render(scene, settings);
        Figures caused = figures(renderer().work());
        std::transform(caused.begin(), caused.end(), before.begin(), caused.begin(), std::minus());
        return caused;
    }
};

/// Five programs: two for visibility, one for the pixels covered, one for what the scene requires, one for the sensor.
TEST_P(GlWorkCounts, AFirstPictureDoesEverythingOnce)
{
    render(twoLightScene("hybrid"), small);
    EXPECT_EQ(figures(renderer().work()), (Figures{1, 1, 1, 1, 5, 1}));
}

TEST_P(GlWorkCounts, EachChangeCausesItsOwnWorkAlone)
{
    const Figures shadingOnly{0, 0, 1, 1, 0, 0};
    const Figures nothing{};
    const std::vector<Change> changes{
        {"nothing", [](Scene&) {}, nothing},
        {"a slider", [](Scene& s) { s.surface.values["n"] = {77.0}; }, shadingOnly},
        {"a value that this model does not have", [](Scene& s) { s.surface.values["kd"] = {0.3}; }, nothing},
        {"a light's direction", [](Scene& s) { s.lights[0].direction.x = 0.9; }, shadingOnly},
        {"a part of the sensor", [](Scene& s) { s.sensor.noise.on = true; }, {0, 0, 0, 1, 1, 0}},
        {"a light's name", [](Scene& s) { s.lights[0].name = "renamed"; }, nothing},
        {"a further light of a known kind", [](Scene& s) { s.lights.push_back(s.lights[0]); }, shadingOnly},
        {"the plain background", [](Scene& s) { s.background.color.x = 0.5; }, shadingOnly},
        {"surroundings that nobody sees", [](Scene& s) { s.environment.kind = EnvironmentKind::Studio; }, nothing},
        {"the exposure", [](Scene& s) { s.sensor.exposure = 1.0; }, {0, 0, 0, 1, 0, 0}},
        {"the camera", [](Scene& s) { s.camera = orbited(s.camera, 0.1, 0.0); }, {0, 1, 1, 1, 0, 0}},
        {"the mesh", [](Scene& s) { s.mesh = square(); }, {1, 1, 1, 1, 0, 0}},
        {"the model", [](Scene& s) { s.surface.model = "phong"; }, {0, 0, 1, 1, 1, 0}},
        {"no point light left", [](Scene& s) { s.lights.pop_back(); }, {0, 0, 1, 1, 1, 0}},
    };
    for (const Change& change : changes) {
        startAnew();
        EXPECT_EQ(workOf(change), change.work) << change.name;
    }
}

TEST_P(GlWorkCounts, AnotherSizeAllocatesAndSeesAnew)
{
    const Change none{"nothing", [](Scene&) {}, {}};
    EXPECT_EQ(workOf(none, {80, 48, 2}), (Figures{0, 1, 1, 1, 0, 1}));
    startAnew();
    EXPECT_EQ(workOf(none, {64, 48, 1}), (Figures{0, 1, 1, 1, 0, 1}));
}

TEST_P(GlWorkCounts, AProgramOnceLinkedIsKept)
{
    Scene scene = twoLightScene("hybrid");
    for (const char* model : {"hybrid", "phong", "lambert", "hybrid", "phong", "lambert"}) {
        scene.surface.model = model;
        render(scene, small);
    }
    EXPECT_EQ(renderer().work().programLinks, 4U + 3U);
    EXPECT_EQ(renderer().work().shadings, 6U);
}

/// A matte surface under lights far away asks for no P: its texture is there from the first model on that does, and stays.
TEST_P(GlWorkCounts, PositionsAreKeptOnceSomethingAsksForThem)
{
    constexpr std::uint64_t samples = 64 * 48 * 4, pixels = 64 * 48;
    Scene scene = twoLightScene("lambert_color");
    scene.lights.pop_back(); // the near one
    render(scene, small);
    EXPECT_EQ(renderer().work().targetBytes, samples * (4 + 4 + 16) + pixels * (16 + 4 + 4));
    const ViewSamples read = renderer().readSamples(); // are those of the view, P included
    scene.surface.model = "hybrid";
    render(scene, small);
    EXPECT_EQ(figures(renderer().work()), (Figures{1, 2, 2, 2, 6, 2}));
    EXPECT_EQ(renderer().work().targetBytes, samples * (4 + 4 + 16 + 16) + pixels * (16 + 4 + 4));
    EXPECT_EQ(read.Px, renderer().readSamples().Px);
    EXPECT_NE(read.Px, std::vector<double>(read.Px.size(), 0.0));
    scene.surface.model = "lambert_color";
    render(scene, small);
    scene.surface.model = "hybrid";
    render(scene, small);
    EXPECT_EQ(figures(renderer().work()), (Figures{1, 2, 4, 4, 6, 2}));
}

TEST_P(GlWorkCounts, BytesAreUploadedOnceAndOnlyThoseOfWhatChanged)
{
    Scene scene = twoLightScene("hybrid");
    render(scene, small);
    const std::uint64_t mesh = 32 * scene.mesh->positions.size() + 12 * scene.mesh->triangles.size();
    const std::uint64_t lights = 2 * 8 * sizeof(float);
    EXPECT_EQ(renderer().work().uploadedBytes, mesh + lights);
    scene.surface.values["n"] = {50.0};
    scene.camera = orbited(scene.camera, 0.1, 0.0);
    render(scene, small);
    EXPECT_EQ(renderer().work().uploadedBytes, mesh + lights);
    scene.lights[0].direction.x += 0.5;
    render(scene, small);
    EXPECT_EQ(renderer().work().uploadedBytes, mesh + 2 * lights);
}

TEST_P(GlWorkCounts, ADragOfASliderOnlyShades)
{
    Scene scene = twoLightScene("hybrid");
    render(scene, small);
    for (int step = 1; step <= 50; ++step) {
        scene.surface.values["ks"] = {0.01 * step};
        render(scene, small);
    }
    EXPECT_EQ(figures(renderer().work()), (Figures{1, 1, 51, 51, 5, 1}));
}

TEST_P(GlWorkCounts, AMeshAndItsSmallStandInTakeTurnsWithoutUploads)
{
    Scene scene = twoLightScene("hybrid");
    const std::shared_ptr<const Mesh> whole = scene.mesh, standIn = square();
    ASSERT_LE(standIn->triangles.size(), whole->triangles.size() / 4);
    for (int turn = 0; turn < 5; ++turn)
        for (const auto& mesh : {whole, standIn}) {
            scene.mesh = mesh;
            render(scene, small);
        }
    EXPECT_EQ(renderer().work().meshUploads, 2U);
    EXPECT_EQ(renderer().work().visibilities, 10U);
}

TEST_P(GlWorkCounts, TwoMeshesOfOneSizeAreNeverKeptTogether)
{
    Scene scene = twoLightScene("hybrid");
    const std::shared_ptr<const Mesh> first = square(), second = square();
    for (int turn = 0; turn < 3; ++turn)
        for (const auto& mesh : {first, second}) {
            scene.mesh = mesh;
            render(scene, small);
        }
    EXPECT_EQ(renderer().work().meshUploads, 6U);
}

TEST_P(GlWorkCounts, ShadesAgainWhenAsked)
{
    const Scene scene = twoLightScene("hybrid");
    render(scene, small);
    renderer().invalidateShading();
    render(scene, small);
    EXPECT_EQ(figures(renderer().work()), (Figures{1, 1, 2, 2, 5, 1}));
}

IN_EVERY_CONTEXT(GlWorkCounts);

} // namespace
} // namespace reflectance::test
