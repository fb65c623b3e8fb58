// The page of fits: a finished fit is shown, explained and applied; what went wrong is said.
#include "app/explorer/ui/workbench/fit_page.h"
#include "core/base/file.h"
#include "core/measured/write.h"
#include "core/render/pictures/render_picture.h"
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

/// A sphere seen from the scene's camera, in truth, as a file.
std::string photographOf(const Scene& scene, const ScratchFolder& folder)
{
    RenderPlan plan;
    plan.backend = Backend::Cpu;
    const auto rendered = renderPicture(scene, {64, 48, 1}, plan);
    EXPECT_TRUE(rendered) << rendered.error().sentence();
    const std::string file = (folder.path / "photograph.exr").string();
    EXPECT_TRUE(writeLinear(file, rendered->image));
    return file;
}

Scene matteScene()
{
    Scene scene = defaultScene();
    scene.surface.model = "oren_nayar";
    scene.surface.values["rho"] = {0.6};
    scene.surface.values["sigma"] = {0.4};
    return scene;
}

FitWish photographed(const Scene& scene, const ScratchFolder& folder)
{
    FitWish wish;
    wish.fromPicture = true;
    wish.model = "oren_nayar";
    wish.photograph =
        std::make_shared<const Photograph>(*photographFrom(photographOf(scene, folder), scene.sensor, Progress()));
    wish.scene = std::make_shared<const Scene>(scene);
    return wish;
}

TEST(FitPage, FitsTheObjectsPixels)
{
    const ScratchFolder folder;
    Progress progress;
    FitWish wish = photographed(matteScene(), folder);
    const auto all = fittedAsWished(wish, progress);
    ASSERT_EQ(all->problem, "");
    // The file holds floats: 2^-24 of each value, from which sigma is found a few times less well.
    EXPECT_NEAR(all->fit.values.at("rho").front(), 0.6, 1e-5);
    EXPECT_NEAR(all->fit.values.at("sigma").front(), 0.4, 1e-4);
    const std::size_t seen = all->observations.rows.size();
    wish.pixels = {{30, 24}, {32, 24}, {34, 26}};
    const auto marked = fittedAsWished(wish, progress);
    EXPECT_EQ(marked->problem, "");
    EXPECT_EQ(marked->observations.rows.size(), 3U);
    EXPECT_GT(seen, 300U);
}

TEST(FitPage, SaysWhatIsWrongWithAPicture)
{
    const ScratchFolder folder;
    Progress progress;
    EXPECT_THAT(photographFrom((folder.path / "missing.png").string(), Sensor(), progress)->problem,
                testing::HasSubstr("missing.png"));
    FitWish wish = photographed(matteScene(), folder);
    wish.pixels = {{0, 0}};
    EXPECT_THAT(fittedAsWished(wish, progress)->problem, testing::HasSubstr("does not show the object"));
}

Faults faultsOf(ExplorerState& state)
{
    const ImVec2 corner{0.0F, 0.0F}, size{900.0F, 320.0F};
    Stage stage(size.x, size.y);
    return sweep(stage, corner, size, {18.0F, 10.0F}, [&] {
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawFitPage(state);
        ImGui::End();
    });
}

void expectExplained(const Faults& faults)
{
    EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
    EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip";
    EXPECT_GT(faults.controls, 0U);
}

TEST(FitPage, ExplainsEveryControlOfAFinishedFit)
{
    const ScratchFolder folder;
    ExplorerState state;
    state.scene = defaultScene();
    state.fit.outcome = std::make_shared<const FitOutcome>(fitted(diffuserIn(folder), "hybrid"));
    expectExplained(faultsOf(state));
}

TEST(FitPage, ExplainsEveryControlBesideAPhotograph)
{
    const ScratchFolder folder;
    Progress progress;
    ExplorerState state;
    state.scene = matteScene();
    state.fit.wish = photographed(state.scene, folder);
    state.fit.outcome = std::make_shared<const FitOutcome>(*fittedAsWished(state.fit.wish, progress));
    expectExplained(faultsOf(state));
}

} // namespace
} // namespace reflectance::explorer
