// The guided tour without a window: every step loads and renders, every claim is measured and holds, and the user's scene
// comes back.
#include "app/explorer/tour.h"

#include "app/explorer/keys.h"
#include "app/explorer/state.h"
#include "core/render/cpu/cpu_renderer.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

using testing::HasSubstr;

class Tour : public testing::TestWithParam<int> {};

TEST_P(Tour, SaysSomethingAsksAndAnswers)
{
    const auto step = tourStep(GetParam());
    ASSERT_TRUE(step) << step.error().sentence();
    EXPECT_FALSE(step->title.empty());
    EXPECT_GE(step->text.size(), 2U);
    std::size_t letters = step->task.size() + step->question.size() + step->answer.size();
    for (const std::string& paragraph : step->text)
        letters += paragraph.size();
    // Twelve steps in half an hour: at 200 words a minute, 1500 letters leave a minute to play.
    EXPECT_LT(letters, 1500U);
    EXPECT_GT(letters, 300U);
    EXPECT_GE(step->choices.size(), 2U);
    EXPECT_LE(step->right, static_cast<int>(step->choices.size()));
    EXPECT_FALSE(step->claims.empty());
}

TEST_P(Tour, ClaimsHoldAsMeasured)
{
    const auto step = tourStep(GetParam());
    ASSERT_TRUE(step);
    for (const Claim& claim : step->claims) {
        const auto value = measured(claim, *step);
        ASSERT_TRUE(value) << claim.says << ": " << value.error().sentence();
        EXPECT_TRUE(holds(claim, *value))
            << claim.says << ": " << *value << " is not within " << claim.low << " .. " << claim.high;
        Claim wrong = claim; // planted: a claim that is off must be noticed
        wrong.low += 0.6 + std::fabs(claim.low);
        wrong.high = wrong.low;
        EXPECT_FALSE(holds(wrong, *value)) << claim.says;
    }
}

TEST_P(Tour, RendersWhatItTalksAbout)
{
    const auto step = tourStep(GetParam());
    ASSERT_TRUE(step);
    Scene scene = step->scene;
    scene.camera = framed(scene.camera, 1.0);
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, {96, 96, 1});
    for (const Scene& variant : {scene, variantB(scene)}) {
        const Image image = shadeSamples(samples, variant, Precision::Double);
        double covered = 0.0, brightest = 0.0;
        for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
            covered += static_cast<double>(image.coverage[pixel]);
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_TRUE(std::isfinite(image.rgb[3 * pixel + c]));
                if (image.coverage[pixel] > 0.0F)
                    brightest = std::max(brightest, static_cast<double>(image.rgb[3 * pixel + c]));
            }
        }
        EXPECT_GT(covered, 800.0) << "the object fills the picture";
        EXPECT_GT(brightest, 0.2) << "and is lit";
    }
}

INSTANTIATE_TEST_SUITE_P(EveryStep, Tour, testing::Range(1, tourLength() + 1));

TEST(TheTour, HasTwelveSteps)
{
    EXPECT_EQ(tourLength(), 12);
    EXPECT_FALSE(tourStep(0));
    EXPECT_FALSE(tourStep(13));
}

TEST(TheTour, RefusesWhatIsNoStep)
{
    for (const auto& [text, problem] : std::vector<std::pair<const char*, const char*>>{
             {"{", "not a step of the tour in JSON"},
             {R"({"title": 3})", "title"},
             {R"({"predict": {"choices": ["a"], "right": 2}})", "1 .. 1"},
             {R"({"claims": [{"says": "x", "measure": {"model": "lambert"}}]})", "'x' has no 'is'"},
             {R"({"scene": {"mesh": "mugg"}})", "mugg"},
             {R"({"version": 2})", "newer program"},
             {R"({"table_of": {}})", "'compare'"}}) {
        const auto step = parseTourStep(text, "a.json");
        ASSERT_FALSE(step) << text;
        EXPECT_THAT(step.error().sentence(), HasSubstr(problem));
    }
}

TEST(Guide, ShowsAStepAndBringsTheSceneBack)
{
    ExplorerState state;
    state.scene = defaultScene();
    state.scene.surface.values["n"] = {123.0};
    press({"c"}, state);
    const Scene before = state.scene;
    showTourStep(state, 8);
    EXPECT_EQ(state.guide.number, 8);
    EXPECT_TRUE(state.compare.on) << "the mug is compared";
    EXPECT_TRUE(usersScene(state) == before) << "what is kept against crashes";
    showTourStep(state, 1);
    EXPECT_FALSE(state.compare.on);
    state.scene.lights.clear(); // the user plays
    press({"Esc"}, state);
    EXPECT_EQ(state.guide.number, 0);
    EXPECT_TRUE(state.scene == before);
    EXPECT_TRUE(state.compare.on);
    EXPECT_EQ(state.preferences.tourStep, 1) << "it remembers where it was";
}

TEST(Guide, StaysWithinTheTour)
{
    ExplorerState state;
    state.scene = defaultScene();
    showTourStep(state, 99);
    EXPECT_EQ(state.guide.number, tourLength());
    showTourStep(state, -3);
    EXPECT_EQ(state.guide.number, 1);
}

TEST(Guide, RevealsAndMeasures)
{
    ExplorerState state;
    state.scene = defaultScene();
    showTourStep(state, 2);
    EXPECT_FALSE(state.guide.revealed);
    revealAnswer(state.guide);
    ASSERT_EQ(state.guide.values.size(), state.guide.step.claims.size());
    EXPECT_NEAR(state.guide.values[0], 0.5, 1e-15);
    showTourStep(state, 2);
    EXPECT_FALSE(state.guide.revealed) << "again from the beginning";
}

TEST(Guide, UndoLeadsOutAndRedoBackIn)
{
    ExplorerState state;
    state.scene = defaultScene();
    const Scene before = state.scene;
    state.history.watch(state, {}, {});
    showTourStep(state, 5);
    state.history.watch(state, {}, {});
    state.history.undo(state);
    EXPECT_EQ(state.guide.number, 0);
    EXPECT_TRUE(state.scene == before);
    state.history.redo(state);
    EXPECT_EQ(state.guide.number, 5);
    EXPECT_EQ(state.guide.step.title, tourStep(5)->title);
}

TEST(Guide, KeysOpenItAndTurnItsPages)
{
    using Kind = Request::Kind;
    ExplorerState state;
    state.scene = defaultScene();
    press({"PageDown"}, state);
    EXPECT_TRUE(state.requests.empty()) << "outside the tour it means nothing";
    press({"g"}, state);
    showTourStep(state, 3);
    press({"PageDown"}, state);
    press({"PageUp"}, state);
    press({"g"}, state);
    ASSERT_EQ(state.requests.size(), 4U);
    EXPECT_EQ(state.requests[0].kind, Kind::ShowTour);
    EXPECT_EQ(state.requests[1].path, "4");
    EXPECT_EQ(state.requests[2].path, "2");
    EXPECT_EQ(state.requests[3].kind, Kind::LeaveCase);
}

} // namespace
} // namespace reflectance::explorer
