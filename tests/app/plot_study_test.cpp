// What the page of curves asks for and gets: the surfaces it overlays, the light it is linked to, and answers that belong to
// their questions.
#include "app/explorer/plot_study.h"
#include "app/explorer/state.h"
#include "core/reflectance/own_model.h"

#include <cmath>
#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

ExplorerState stateWith(const std::string& model)
{
    ExplorerState state;
    state.scene = defaultScene();
    state.scene.surface.model = model;
    return state;
}

std::vector<std::string> namesOf(const ExplorerState& state)
{
    std::vector<std::string> names;
    for (const PlottedSurface& surface : plottedSurfaces(state))
        names.push_back(surface.named.name);
    return names;
}

TEST(PlottedSurfaces, BeginWithTheCurrentOneAndHoldEachOnce)
{
    ExplorerState state = stateWith("phong");
    state.curves.overlays = {"lambert", "phong", "unknown", "ggx"};
    EXPECT_THAT(namesOf(state), testing::ElementsAre("Phong", "Lambert", "GGX"));
}

TEST(PlottedSurfaces, HoldBWhileTwoAreCompared)
{
    ExplorerState state = stateWith("phong");
    state.scene.other = state.scene.surface;
    state.scene.other->model = "lambert";
    EXPECT_THAT(namesOf(state), testing::ElementsAre("Phong"));
    state.compare.on = true;
    EXPECT_THAT(namesOf(state), testing::ElementsAre("A: Phong", "B: Lambert"));
}

TEST(PlottedSurfaces, HoldTheUsersOwnModelBesideTheCurrentOne)
{
    ExplorerState state = stateWith("phong");
    const auto own =
        ownModel("mine.glsl", "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return 0.25 * max(dot(N, L), 0.0) * I; }");
    ASSERT_TRUE(own) << own.error().sentence();
    state.scene.surface.own = *own;
    state.curves.overlays = {"mine"};
    EXPECT_THAT(namesOf(state), testing::ElementsAre("Phong", "mine"));
}

TEST(PlotQuestion, IsTheSameUntilSomethingThatIsShownChanges)
{
    ExplorerState state = stateWith("phong");
    state.curves.tab = PlotTab::Lobe;
    const PlotQuestion before = questionOf(state);
    EXPECT_EQ(questionOf(state), before);
    state.curves.view.azimuth += 1.0;
    state.scene.lights[0].direction.x += 0.1;
    EXPECT_EQ(questionOf(state), before) << "lobes are turned without being made anew, and have a light of their own";
    state.scene.surface.values["n"] = {123.0};
    EXPECT_FALSE(questionOf(state) == before);
}

TEST(PlotQuestion, OfBallsFollowsTheLight)
{
    ExplorerState state = stateWith("phong");
    state.curves.tab = PlotTab::Balls;
    const PlotQuestion before = questionOf(state);
    state.scene.lights[0].direction.x += 0.1;
    EXPECT_FALSE(questionOf(state) == before);
}

TEST(PlotAnswer, HoldsWhatItsTabShows)
{
    for (const PlotTab tab : {PlotTab::Lobe, PlotTab::Balls, PlotTab::Wedge, PlotTab::Map, PlotTab::Albedo}) {
        ExplorerState state = stateWith("lambert");
        state.curves.tab = tab;
        Progress progress;
        const auto answer = answered(questionOf(state), progress);
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->question, questionOf(state));
        EXPECT_EQ(answer->lobes.lobes.size(), tab == PlotTab::Lobe ? 1U : 0U);
        EXPECT_EQ(answer->balls.balls.size(), tab == PlotTab::Balls ? 1U : tab == PlotTab::Wedge ? 7U : 0U);
        EXPECT_EQ(answer->map.values.empty(), tab != PlotTab::Map);
        EXPECT_EQ(answer->albedo.series.size(), tab == PlotTab::Albedo ? 1U : 0U);
    }
}

TEST(PlotAnswer, OfAWedgeWithoutAParameterIsEmpty)
{
    ExplorerState state = stateWith("lambert_color");
    state.curves.tab = PlotTab::Wedge;
    Progress progress;
    const auto answer = answered(questionOf(state), progress);
    ASSERT_TRUE(answer);
    EXPECT_TRUE(answer->balls.balls.empty());
}

TEST(LightAngle, IsKeptByTheLightThatItMoves)
{
    ExplorerState state = stateWith("phong");
    for (const double angle : {0.0, 30.0, 75.0, 88.0}) {
        setLightAngle(state, angle);
        EXPECT_NEAR(*lightAngle(state), angle, 1e-9);
    }
    const Light before = state.scene.lights[0];
    setLightAngle(state, *lightAngle(state));
    EXPECT_NEAR(length(state.scene.lights[0].position), length(before.position), 1e-12) << "its distance stays";
    state.selectedLight = -1;
    EXPECT_FALSE(lightAngle(state));
}

TEST(LightAngle, IsThatAtTheProbedPoint)
{
    ExplorerState state = stateWith("phong");
    Light& light = state.scene.lights[0];
    light.kind = LightKind::Point;
    light.position = {1.0, 2.0, 3.0};
    ProbePlace place;
    place.point.P = {1.0, 1.0, 3.0};
    place.point.N = {0.0, 0.6, 0.8};
    state.probe.probe(place);
    // L is the y axis: its cosine with N is 0.6. Roundings of an arc tangent in degrees.
    EXPECT_NEAR(*lightAngle(state), 53.13010235415598, 1e-12);
    setLightAngle(state, 20.0);
    EXPECT_NEAR(*lightAngle(state), 20.0, 1e-9);
    EXPECT_NEAR(length(light.position - place.point.P), 1.0, 1e-12) << "its distance from the point stays";
}

/// A light along the viewer's direction is at z; what is left of an orthonormal turn is 1e-15.
TEST(BallLights, AreTheScenesAsTheViewerHasThem)
{
    ExplorerState state = stateWith("phong");
    state.scene.lights.resize(1);
    state.scene.lights[0].kind = LightKind::Directional;
    state.scene.lights[0].direction = 3.0 * frameOf(state.scene.camera).back;
    const auto lights = ballLights(state.scene);
    ASSERT_EQ(lights.size(), 1U);
    EXPECT_NEAR(normalized(lights[0].L).z, 1.0, 1e-12);
    state.scene.lights[0].on = false;
    EXPECT_TRUE(ballLights(state.scene).empty());
}

} // namespace
} // namespace reflectance::explorer
