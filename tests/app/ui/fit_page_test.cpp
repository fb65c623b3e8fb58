// The page of fits: a finished fit is shown, explained and applied; what went wrong is said.
#include "app/explorer/ui/workbench/fit_page.h"
#include "core/base/file.h"
#include "core/measured/write.h"
#include "tests/app/scratch_folder.h"
#include "tests/app/ui/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance::explorer {
namespace {

/// A grey diffuser of albedo 0.5 as a file.
std::string diffuserIn(const ScratchFolder& folder)
{
    Table table;
    table.axes = {{0.2, 0.6, 1.0}, {0.1, 0.5, 0.9}};
    table.values.assign(9, 0.5 / std::numbers::pi);
    const std::string file = (folder.path / "diffuser.csv").string();
    EXPECT_TRUE(writeAtomically(file, csvText(table)));
    return file;
}

FitOutcome fitted(const std::string& file, const std::string& model)
{
    FitWish wish;
    wish.file = file;
    wish.model = model;
    Progress progress;
    return *fittedAsWished(wish, progress);
}

TEST(FitPage, FitsAFileAndAppliesWhatItFound)
{
    const ScratchFolder folder;
    const FitOutcome outcome = fitted(diffuserIn(folder), "lambert");
    EXPECT_EQ(outcome.problem, "");
    Scene scene = defaultScene();
    applyFit(outcome, scene);
    EXPECT_EQ(scene.surface.model, "lambert");
    EXPECT_NEAR(scene.surface.values.at("kd").front(), 0.5, 1e-9); // the file has 17 digits; the fit is linear
}

TEST(FitPage, SaysWhatWentWrong)
{
    const ScratchFolder folder;
    EXPECT_THAT(fitted((folder.path / "missing.csv").string(), "lambert").problem, testing::HasSubstr("missing.csv"));
    EXPECT_THAT(fitted(diffuserIn(folder), "mirror").problem, testing::HasSubstr("cannot be fitted"));
}

TEST(FitPage, GivesNothingWhenStopped)
{
    const ScratchFolder folder;
    Progress progress;
    progress.cancel = true;
    FitWish wish;
    wish.file = diffuserIn(folder);
    EXPECT_FALSE(fittedAsWished(wish, progress));
}

TEST(FitPage, ExplainsEveryControlOfAFinishedFit)
{
    const ScratchFolder folder;
    const ImVec2 corner{0.0F, 0.0F}, size{900.0F, 320.0F};
    Stage stage(size.x, size.y);
    ExplorerState state;
    state.scene = defaultScene();
    state.fit.outcome = std::make_shared<const FitOutcome>(fitted(diffuserIn(folder), "hybrid"));
    const Faults faults = sweep(stage, corner, size, {18.0F, 10.0F}, [&] {
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawFitPage(state);
        ImGui::End();
    });
    EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
    EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip";
    EXPECT_GT(faults.controls, 0U);
}

} // namespace
} // namespace reflectance::explorer
