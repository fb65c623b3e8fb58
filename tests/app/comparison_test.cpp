// Two variants of one scene: what the keys do with them, where they stand, and that nothing of the scene is lost.
#include "app/explorer/comparison.h"
#include "app/explorer/keys.h"
#include "core/reflectance/evaluate.h"

#include <cmath>
#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

ExplorerState startScreen()
{
    ExplorerState state;
    state.scene = defaultScene();
    return state;
}

TEST(Compare, BeginsWithACopyAndKeepsBWhileItIsNotLookedAt)
{
    ExplorerState state = startScreen();
    press({"c"}, state);
    ASSERT_TRUE(state.compare.on && state.scene.other);
    EXPECT_EQ(*state.scene.other, state.scene.surface);
    state.scene.other->model = "phong";
    press({"c"}, state);
    EXPECT_FALSE(state.compare.on);
    ASSERT_TRUE(state.scene.other);
    press({"c"}, state);
    EXPECT_EQ(state.scene.other->model, "phong");
}

TEST(Compare, TheHandChangesOneVariantOnly)
{
    ExplorerState state = startScreen();
    press({"x"}, state);
    EXPECT_FALSE(state.compare.handOnB) << "there is no B yet";
    press({"c"}, state);
    press({"x"}, state);
    const Surface a = state.scene.surface;
    press({"m"}, state); // the next model
    EXPECT_EQ(state.scene.surface, a);
    EXPECT_NE(state.scene.other->model, a.model);
    press({"c"}, state);
    EXPECT_EQ(&surfaceInHand(state.compare, state.scene), &state.scene.surface)
        << "without a comparison A is all there is";
}

TEST(Compare, SwapExchangesAAndB)
{
    ExplorerState state = startScreen();
    swapVariants(state.scene); // nothing to swap with
    const Surface a = state.scene.surface;
    state.scene.other = Surface{"phong", {}};
    swapVariants(state.scene);
    EXPECT_EQ(state.scene.surface.model, "phong");
    EXPECT_EQ(*state.scene.other, a);
}

TEST(Clay, IsOneKeyFromTheStartAndShowsEqualAlbedos)
{
    ExplorerState state = startScreen();
    press({"b"}, state);
    EXPECT_TRUE(state.compare.on);
    EXPECT_EQ(state.compare.mode, CompareMode::SideBySide);
    EXPECT_EQ(state.scene.surface.model, "lambert_color");
    EXPECT_EQ(state.scene.other->model, "oren_nayar");
    const auto& K = state.scene.surface.values.at("K");
    EXPECT_EQ((std::vector<double>{K[0], K[4], K[8]}), state.scene.other->values.at("rho"));
    // Seen from near the light; at 90 degrees between them rough clay would not look flat.
    const Camera& camera = state.scene.camera;
    EXPECT_GT(dot(normalized(camera.eye - camera.target), state.scene.lights[0].direction), std::cos(0.35));
}

TEST(Clay, RoughClayIsBrighterAtItsEdgeAndDarkerInTheMiddle)
{
    ExplorerState state = startScreen();
    press({"b"}, state);
    const auto factor = [](const Surface& surface, const Vec3d& N) {
        // Light and viewer in one place, as in the photograph.
        const Model& model = modelOf(surface);
        const Observation row{N, {0, 0, 1}, {{{0, 0, 1}, Vec3d(1.0), 0.0}}};
        return evaluate(model, flatValues(model.text, surface.values), std::span(&row, 1), Precision::Double)[0].x;
    };
    const Vec3d edge{std::sin(1.3), 0, std::cos(1.3)}, middle{0, 0, 1};
    EXPECT_GT(factor(*state.scene.other, edge), 1.5 * factor(state.scene.surface, edge));
    EXPECT_LT(factor(*state.scene.other, middle), factor(state.scene.surface, middle));
}

TEST(Clay, TheSecondPressBringsBackWhatWasThere)
{
    ExplorerState state = startScreen();
    press({"c"}, state);
    state.scene.other->model = "mirror";
    state.compare.mode = CompareMode::Wipe;
    const Scene before = state.scene;
    press({"b"}, state);
    press({"b"}, state);
    EXPECT_EQ(state.scene.surface, before.surface);
    EXPECT_EQ(state.scene.other, before.other);
    EXPECT_EQ(state.scene.lights, before.lights);
    EXPECT_TRUE(state.compare.on);
    EXPECT_EQ(state.compare.mode, CompareMode::Wipe);
}

TEST(Panes, SideBySideShareTheAreaInEqualHalves)
{
    const Area area{10, 20, 801, 300};
    CompareView compare;
    EXPECT_EQ(panesOf(compare, area, 1).a.width, area.width) << "nothing is compared";
    compare.on = true;
    const Panes panes = panesOf(compare, area, 1);
    EXPECT_EQ(panes.a.width, panes.b.width) << "or the two cameras would differ";
    EXPECT_EQ(panes.a.x, area.x);
    EXPECT_EQ(panes.b.right(), area.right());
    EXPECT_LE(panes.a.right(), panes.b.x);
    compare.mode = CompareMode::Wipe;
    EXPECT_EQ(panesOf(compare, area, 1).b.width, area.width);
}

} // namespace
} // namespace reflectance::explorer
