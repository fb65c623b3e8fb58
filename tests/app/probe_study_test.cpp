// Probes in the window say what the core says of the point, stay where they were put, and touch nothing else.
#include "app/explorer/probe_study.h"

#include "app/explorer/state.h"
#include "app/explorer/viewed_scene.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/scene/same_scene.h"
#include "core/scene/scene_file.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

constexpr ViewSize size{160, 120};
constexpr Cursor onMug{80.0, 60.0}, beside{1.0, 1.0};

ExplorerState probedState(Cursor cursor = onMug)
{
    ExplorerState state;
    state.scene = defaultScene();
    probeUnder(state, cursor, size);
    examine(state, viewedScene(state), size);
    return state;
}

TEST(ProbeStudy, SaysWhatTheCoreSaysBitForBit)
{
    ExplorerState state = probedState();
    state.scene.other = state.scene.surface;
    state.scene.other->model = "oren_nayar";
    state.compare.on = true;
    state.scene.lights[0].direction = normalized(Vec3d(0.3, 0.8, 0.5)); // live: the light has moved since the click
    examine(state, viewedScene(state), size);
    const FoundProbe* found = state.probe.found();
    ASSERT_TRUE(found && found->b);
    const auto point = pointAt(*state.scene.mesh, state.scene.camera, 80.5, 60.5, size.width, size.height);
    ASSERT_TRUE(point);
    const Probe a = probeAt(state.scene, *point), b = probeAt(variantB(state.scene), *point);
    EXPECT_EQ(found->a.value, a.value);
    EXPECT_EQ(found->b->value, b.value);
    EXPECT_EQ(found->a.codes, a.codes);
    EXPECT_NE(found->a.value, found->b->value) << "planted: A's for both would pass";
    EXPECT_EQ(textOf(*found), "A\n" + probeText(a) + "\nB\n" + probeText(b));
}

TEST(ProbeStudy, IsPutAwayByAClickBesideTheObject)
{
    ExplorerState state = probedState();
    EXPECT_TRUE(state.probe.found());
    probeUnder(state, beside, size);
    examine(state, state.scene, size);
    EXPECT_FALSE(state.probe.found());
    EXPECT_FALSE(state.probe.looks(state.scene));
}

TEST(ProbeStudy, PinsStayOnTheirPointWhenTheCameraMoves)
{
    ExplorerState state = probedState();
    state.probe.pin(state.scene);
    ASSERT_EQ(state.scene.pins.size(), 1U);
    EXPECT_FALSE(state.probe.loose);
    const Vec3d P = state.scene.pins[0].P;
    const ProbedPoint before = *pointIn(state.scene.pins[0], state.scene, size);
    EXPECT_NEAR(before.x, 80.5, 1e-9); // projected again: roundings of numbers near 100
    state.scene.camera = orbited(state.scene.camera, 0.2, 0.05);
    examine(state, viewedScene(state), {320, 200});
    const ProbedPoint& after = state.probe.found()->a.point;
    EXPECT_EQ(after.P, P);
    EXPECT_NE(after.x, before.x);
    EXPECT_EQ(after.width, 320);
    const auto met = pointAt(*state.scene.mesh, state.scene.camera, after.x, after.y, 320, 200);
    ASSERT_TRUE(met);
    EXPECT_LE(length(met->P - P), 1e-12) << "the picture shows the pin where it lies"; // a projection and its inverse
    EXPECT_EQ(pinAt(state.scene, {320, 200}, {after.x + 3.0, after.y}, 5.0), std::optional<std::size_t>(0));
    EXPECT_FALSE(pinAt(state.scene, {320, 200}, {after.x + 6.0, after.y}, 5.0));
}

TEST(ProbeStudy, AClickOnAPinLooksAtItAgain)
{
    ExplorerState state = probedState();
    state.probe.pin(state.scene);
    probeUnder(state, {70.0, 40.0}, size);
    EXPECT_FALSE(state.probe.picked);
    EXPECT_TRUE(state.probe.loose);
    probeUnder(state, {82.0, 61.0}, size);
    EXPECT_EQ(state.probe.picked, std::optional<std::size_t>(0));
}

TEST(ProbeStudy, ListsPinsAndTakesThemOff)
{
    ExplorerState state = probedState();
    for (std::size_t i = 0; i < mostPins + 2; ++i) {
        state.probe.probe(placeAt(state.scene, onMug, size));
        state.probe.pin(state.scene);
    }
    EXPECT_EQ(state.scene.pins.size(), mostPins);
    examine(state, state.scene, size);
    EXPECT_EQ(listed(state.probe, state.scene).size(), mostPins + 1) << "and the one that found no room";
    EXPECT_EQ(listed(state.probe, state.scene).back().name, "here");
    state.probe.pick(0);
    for (std::size_t i = 0; i < mostPins; ++i)
        state.probe.remove(state.scene);
    EXPECT_TRUE(state.scene.pins.empty());
    EXPECT_FALSE(state.probe.picked);
    EXPECT_TRUE(state.probe.looks(state.scene)) << "the loose one is looked at again";
    state.probe.remove(state.scene);
    EXPECT_FALSE(state.probe.looks(state.scene));
    state.probe.remove(state.scene); // nothing is left, and nothing happens
}

TEST(ProbeStudy, APinOfAnotherMeshWaitsForIt)
{
    ExplorerState state = probedState();
    state.probe.pin(state.scene);
    const Scene mug = state.scene;
    state.scene.meshFile = "sphere";
    ASSERT_TRUE(readMeshOf(state.scene));
    examine(state, state.scene, size);
    EXPECT_FALSE(state.probe.found());
    EXPECT_TRUE(listed(state.probe, state.scene).empty());
    EXPECT_FALSE(pinAt(state.scene, size, onMug, 50.0));
    state.scene = mug;
    examine(state, state.scene, size);
    EXPECT_TRUE(state.probe.found());
}

TEST(ProbeStudy, PinsAreSavedWithTheSceneAndLookTheSameAfterwards)
{
    ExplorerState state = probedState();
    state.probe.pin(state.scene);
    state.scene.pins[0].name = "rim";
    examine(state, state.scene, size);
    const Probe before = state.probe.found()->a;
    const auto read = parseScene(sceneText(state.scene, ""), "a.json", "");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->pins, state.scene.pins);
    ExplorerState restored;
    restored.scene = *read;
    restored.probe.pick(0);
    examine(restored, restored.scene, size);
    ASSERT_TRUE(restored.probe.found());
    EXPECT_EQ(restored.probe.found()->a.value, before.value);
    EXPECT_EQ(listed(restored.probe, restored.scene).at(0).name, "rim");
    // What a probe of the same pixel finds, but for the roundings of a point that is projected and met again.
    const auto met =
        pointAt(*state.scene.mesh, state.scene.camera, before.point.x, before.point.y, size.width, size.height);
    EXPECT_LE(length(probeAt(state.scene, *met).value - before.value), 1e-12);
}

TEST(ProbeStudy, PinsAreUndone)
{
    ExplorerState state = probedState();
    state.history.watch(state, {}, {});
    state.probe.pin(state.scene);
    state.history.watch(state, {}, {});
    EXPECT_EQ(state.history.undoName(), "Pin 1");
    state.scene.pins[0].name = "rim";
    state.history.watch(state, {}, {});
    EXPECT_EQ(state.history.undoName(), "Rename pin 1");
    state.history.undo(state);
    state.history.undo(state);
    EXPECT_TRUE(state.scene.pins.empty());
    examine(state, state.scene, size);
    EXPECT_FALSE(state.probe.found()) << "what was looked at is gone";
    state.history.redo(state);
    state.history.redo(state);
    ASSERT_EQ(state.scene.pins.size(), 1U);
    EXPECT_EQ(state.scene.pins[0].name, "rim");
}

TEST(ProbeStudy, LeavesSceneAndHistoryAloneUntilItIsPinned)
{
    ExplorerState state;
    state.scene = defaultScene();
    state.history.watch(state, {}, {});
    const Scene before = state.scene;
    probeUnder(state, onMug, size);
    state.probe.term = "specular";
    examine(state, viewedScene(state), size);
    state.history.watch(state, {}, {});
    EXPECT_TRUE(state.scene == before);
    EXPECT_FALSE(state.history.canUndo());
}

TEST(ProbeStudy, HasALobeForEachVariantWhereItIsWanted)
{
    ExplorerState state = probedState();
    EXPECT_TRUE(state.probe.lobeA && state.probe.lobeA->largest > 0.0);
    EXPECT_FALSE(state.probe.lobeB);
    state.scene.other = state.scene.surface;
    state.scene.other->model = "lambert";
    state.compare.on = true;
    examine(state, state.scene, size);
    ASSERT_TRUE(state.probe.lobeB);
    EXPECT_NE(state.probe.lobeA->largest, state.probe.lobeB->largest);
    state.probe.lobe = false;
    examine(state, state.scene, size);
    EXPECT_FALSE(state.probe.lobeA);
    state.probe.lobe = true;
    for (Light& light : state.scene.lights)
        light.on = false;
    examine(state, state.scene, size);
    EXPECT_FALSE(state.probe.lobeA) << "no light, no lobe";
}

struct Drawn {
    Scene scene = defaultScene();
    ViewSamples samples;
    Image image;

    Drawn()
    {
        samples = sampleView(*makeRayScene(scene.mesh), scene.camera, {size.width, size.height, 2});
        image = shadeSamples(samples, scene, Precision::Float);
    }
};

TEST(ProbedPixel, IsHeldAgainstDouble)
{
    Drawn drawn;
    const auto place = placeAt(drawn.scene, {80.5, 60.5}, size);
    ASSERT_TRUE(place);
    auto pixel = pixelOf(drawn.samples, drawn.image, drawn.scene, place->point);
    ASSERT_TRUE(pixel && pixel->drawn);
    EXPECT_TRUE(pixel->seen);
    EXPECT_EQ(pixel->drawn->drawn.x, static_cast<double>(drawn.image.at(80, 60)[0]));
    EXPECT_LE(pixel->drawn->ratio, 1.0);
    drawn.image.at(80, 60)[1] += 0.01F; // planted
    pixel = pixelOf(drawn.samples, drawn.image, drawn.scene, place->point);
    EXPECT_GT(pixel->drawn->ratio, 1.0);
    EXPECT_NEAR(pixel->drawn->difference, 0.01, 1e-5); // less what GL and double differ by
}

TEST(ProbedPixel, KnowsAHiddenPoint)
{
    const Drawn drawn;
    Scene behind = drawn.scene;
    behind.camera.eye = -behind.camera.eye;
    const auto place = placeAt(behind, {80.5, 60.5}, size);
    ASSERT_TRUE(place);
    const auto pixel = pixelOf(drawn.samples, drawn.image, drawn.scene, pointIn(*place, drawn.scene.camera, size));
    ASSERT_TRUE(pixel);
    EXPECT_FALSE(pixel->seen);
    ProbedPoint outside = place->point;
    outside.x = -1.0;
    EXPECT_FALSE(pixelOf(drawn.samples, drawn.image, drawn.scene, outside));
}

TEST(ViewedScene, ShowsATermAndNothingThatTheSceneLacks)
{
    ExplorerState state = probedState();
    const Vec3d whole = state.probe.found()->a.value;
    Vec3d sum;
    for (const char* term : {"diffuse", "specular"}) {
        state.probe.term = term;
        EXPECT_TRUE(seesTermAlone(state));
        examine(state, viewedScene(state), size);
        sum += state.probe.found()->a.value;
    }
    EXPECT_LE(length(sum - whole), 1e-15); // two lights and two terms, summed in another order
    state.scene.surface.model = "phong";
    EXPECT_FALSE(seesTermAlone(state)) << "Phong's is one term";
    EXPECT_TRUE(viewedScene(state) == shownScene(state));
}

TEST(ViewedScene, IsTheShownOneWithoutAWish)
{
    ExplorerState state = probedState();
    state.soloLight = 1;
    EXPECT_TRUE(viewedScene(state) == shownScene(state));
    state.probe.term = "offdiagonal";
    EXPECT_FALSE(viewedScene(state).lights[0].on) << "solo goes with it";
    EXPECT_EQ(wordsFor("offdiagonal"), "off-diagonal K");
    EXPECT_EQ(wordsFor("diffuse"), "diffuse term");
    EXPECT_EQ(wordsFor("term 2"), "term 2");
}

} // namespace
} // namespace reflectance::explorer
