// A hazard's case takes the place of the user's scene, and the scene comes back exactly as it was.
#include "app/explorer/exhibition.h"

#include "app/explorer/keys.h"
#include "app/explorer/state.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

using testing::HasSubstr;

ExplorerState stateAtWork()
{
    ExplorerState state;
    state.scene = defaultScene();
    state.scene.surface.values["n"] = {123.0};
    state.scene.camera.eye = {1, 2, 3};
    state.selectedLight = 1;
    state.soloLight = 0;
    state.turntable = true;
    return state;
}

void expectAtWork(const ExplorerState& state)
{
    const ExplorerState fresh = stateAtWork();
    EXPECT_EQ(state.scene.meshFile, fresh.scene.meshFile);
    EXPECT_EQ(state.scene.surface, fresh.scene.surface);
    EXPECT_EQ(state.scene.camera, fresh.scene.camera);
    EXPECT_EQ(state.scene.lights, fresh.scene.lights);
    EXPECT_EQ(state.selectedLight, 1);
    EXPECT_EQ(state.soloLight, 0);
    EXPECT_TRUE(state.turntable);
    EXPECT_FALSE(state.putAside);
}

Finding findingOf(const std::string& id)
{
    return runExtremes(programInstruments(nullptr, "no GL here"), id).front();
}

TEST(Exhibition, ShowsTheCaseAndBringsTheSceneBack)
{
    ExplorerState state = stateAtWork();
    showCase(state, findingOf("H04"));
    ASSERT_TRUE(state.putAside);
    EXPECT_THAT(state.putAside->title, HasSubstr("H04"));
    EXPECT_EQ(state.scene.surface.model, "phong");
    EXPECT_EQ(state.scene.surface.values.at("n"), std::vector<double>{1e7});
    EXPECT_FALSE(state.turntable);
    EXPECT_EQ(usersScene(state).surface.values.at("n"), std::vector<double>{123.0}) << "what is kept against crashes";
    state.scene.surface.values["n"] = {5.0}; // the user plays with the case
    EXPECT_TRUE(leaveCase(state));
    expectAtWork(state);
    EXPECT_FALSE(leaveCase(state)) << "it is there already";
}

TEST(Exhibition, OneCaseAfterAnotherStillLeadsBack)
{
    ExplorerState state = stateAtWork();
    for (const char* id : {"H04", "H20", "H61", "H54"})
        showCase(state, findingOf(id));
    EXPECT_THAT(state.putAside->title, HasSubstr("H54"));
    press({"Esc"}, state);
    expectAtWork(state);
}

TEST(Exhibition, SaysWhyThereIsNothingToSee)
{
    ExplorerState state = stateAtWork();
    showCase(state, findingOf("H07"));
    expectAtWork(state);
    ASSERT_TRUE(state.message);
    EXPECT_THAT(state.message->text, HasSubstr("refused"));
}

TEST(Exhibition, AMessageIsClosedBeforeTheCase)
{
    ExplorerState state = stateAtWork();
    showCase(state, findingOf("H04"));
    state.message = Message{"on top", false};
    press({"Esc"}, state);
    EXPECT_TRUE(state.putAside);
    press({"Esc"}, state);
    expectAtWork(state);
}

TEST(Exhibition, TheStudyEndsWithTheLosses)
{
    ExtremesStudy study;
    study.start();
    study.tried = study.ids.size() - 1; // the last hazard alone, to be quick
    const Instruments instruments = programInstruments(nullptr, "no GL here");
    float before = study.done();
    for (int steps = 0; study.running && steps < 1000; ++steps) {
        study.step(instruments);
        EXPECT_GE(study.done(), before);
        before = study.done();
    }
    EXPECT_FALSE(study.running);
    EXPECT_EQ(study.done(), 1.0F);
    EXPECT_EQ(study.losses.size(), sweepTasks(instruments).size());
    EXPECT_GT(study.losses.size(), 30U);
}

} // namespace
} // namespace reflectance::explorer
