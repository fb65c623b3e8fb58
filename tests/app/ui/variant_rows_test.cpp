// The list of kept surfaces: keeping, choosing and removing, and controls that say what they do.
#include "app/explorer/ui/variant_rows.h"
#include "app/explorer/ui/widgets.h"
#include "core/scene/variants.h"
#include "tests/app/ui/sweep.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

const ImVec2 place{0.0F, 0.0F}, size{340.0F, 300.0F};

ExplorerState stateWithTwo()
{
    ExplorerState state;
    state.scene = defaultScene();
    state.scene.surface.model = "hybrid";
    keepVariant(state.scene, state.scene.surface);
    state.scene.surface.model = "oren_nayar";
    keepVariant(state.scene, state.scene.surface);
    return state;
}

TEST(VariantRows, AnyTwoAreAAndB)
{
    ExplorerState state = stateWithTwo();
    showAsB(state, 1);
    showAsA(state, 0);
    EXPECT_EQ(state.scene.surface.model, "hybrid");
    ASSERT_TRUE(state.compare.on && state.scene.other);
    EXPECT_EQ(state.scene.other->model, "oren_nayar");
    state.scene.surface.values["n"] = {7.0};
    EXPECT_FALSE(state.scene.surface == state.scene.variants[0].surface) << "what is kept stays as it was";
    showAsA(state, 1);
    showAsB(state, 0);
    EXPECT_EQ(state.scene.other->model, "hybrid");
}

TEST(VariantRows, EveryControlSaysWhatItDoes)
{
    ExplorerState state = stateWithTwo();
    Stage stage(size.x, size.y);
    const auto draw = [&] {
        ImGui::SetNextWindowPos(place);
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("rows", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        variantRows(state);
        ImGui::End();
    };
    const Scene before = state.scene;
    stage.click({30.0F, 16.0F}, draw); // opens the fold
    const Faults faults = sweep(stage, place, {size.x, 140.0F}, {6.0F, 5.0F}, draw);
    EXPECT_TRUE(faults.shared.empty());
    EXPECT_TRUE(faults.silent.empty());
    EXPECT_GE(faults.controls, 12U) << "the fold, two rows of five controls, and the button that keeps";
    EXPECT_EQ(state.scene.variants, before.variants) << "looking changes nothing";
}

} // namespace
} // namespace reflectance::explorer
