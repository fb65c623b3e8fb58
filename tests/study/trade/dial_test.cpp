// The dial: what it chooses holds on the whole picture, also where the probe saw nothing of the highlight.
#include "core/study/trade/dial.h"
#include "core/study/trade/rung.h"
#include "core/study/trade/workshop.h"
#include "tests/study/trade/scenes.h"

#include <cmath>
#include <gmock/gmock.h>

namespace reflectance::test {
namespace {

using testing::HasSubstr;

DialWish within(double tolerance)
{
    DialWish wish;
    wish.tolerance = tolerance;
    wish.probeSide = 16;
    return wish;
}

/// The error of a recipe on the picture, found without the dial.
double errorOf(const Recipe& recipe, const Scene& scene)
{
    Workshop workshop(scene.mesh, scene.camera, nullptr);
    const Judge judge(Workshop::truth(scene, recipe.settings, nullptr), gainOf(scene.sensor));
    const auto prepared = workshop.prepare(recipe);
    return judge.errorOf(*workshop.picture(*prepared)).max;
}

TEST(Dial, ChoosesWhatHoldsOnTheWholePicture)
{
    const Scene scene = shinyScene();
    const auto answer = dialled(scene, smallSettings, within(0.2), nullptr);
    ASSERT_TRUE(answer) << answer.error().sentence();
    ASSERT_TRUE(answer->chosen);
    EXPECT_EQ(answer->chosen->recipe.settings.width, smallSettings.width);
    EXPECT_LE(errorOf(answer->chosen->recipe, scene), 0.2);
    EXPECT_GT(answer->chosen->shade.repetitions, 0);
    EXPECT_THAT(sentencesOf(*answer, within(0.2))[0], HasSubstr("Chosen: "));
}

/// A flat square that fills the view and mirrors a light into one point: at n = 1e6 its highlight is 0.0047 wide, between the
/// places at which a probe of 16 pixels takes its 64 samples. The whole picture has pixels on it.
Scene needleScene()
{
    Mesh mesh;
    mesh.positions = {{-0.7, -0.7, 0.0}, {0.7, -0.7, 0.0}, {0.7, 0.7, 0.0}, {-0.7, 0.7, 0.0}};
    mesh.normals.assign(4, {0.0, 0.0, 1.0});
    mesh.fileVertex = {0, 1, 2, 3};
    mesh.fileVertexCount = 4;
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    Scene scene = shinyScene();
    scene.mesh = std::make_shared<const Mesh>(std::move(mesh));
    scene.camera.eye = {0.0, 0.0, 2.0};
    scene.lights.resize(1);
    scene.lights[0].direction = {0.0213, 0.0371, 1.0};
    scene.lights[0].intensity = Vec3d(1.0);
    scene.surface.values = {{"ks", {1.0}}, {"n", {1e6}}, {"K", {0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5}}};
    return scene;
}

TEST(Dial, IsNotFooledByTheHighlightThatItsProbeMisses)
{
    const Scene scene = needleScene();
    constexpr double tolerance = 0.02;
    Recipe matte{scene, {16, 16, 4}};
    ASSERT_TRUE(applyRung(*findRung("no_highlight"), matte).skipped.empty());
    EXPECT_LE(errorOf(matte, scene), tolerance) << "the planted fault: the probe approves of leaving it out";
    const RenderSettings settings{160, 160, 4};
    matte.settings = settings;
    EXPECT_GT(errorOf(matte, scene), tolerance);

    const auto answer = dialled(scene, settings, within(tolerance), nullptr);
    ASSERT_TRUE(answer) << answer.error().sentence();
    ASSERT_TRUE(answer->chosen);
    EXPECT_THAT(nameOf(answer->chosen->recipe), testing::Not(HasSubstr("no_highlight")));
    EXPECT_LE(errorOf(answer->chosen->recipe, scene), tolerance);
}

TEST(Dial, ChecksAChoiceOnAChangedScene)
{
    Recipe matte{shinyScene(), smallSettings};
    for (const char* id : {"simd", "no_highlight"})
        ASSERT_TRUE(applyRung(*findRung(id), matte).skipped.empty());
    Scene changed = shinyScene();
    const auto before = recheckedOn(changed, smallSettings, matte);
    ASSERT_TRUE(before);
    EXPECT_EQ(before->max, errorOf(matte, changed)) << "on the same scene nothing changes";
    changed.surface.values["ks"] = {2.0};
    EXPECT_GT(recheckedOn(changed, smallSettings, matte)->max, before->max + 0.5)
        << "a stronger highlight is missed more";
    changed.surface.model = "lambert";
    EXPECT_FALSE(recheckedOn(changed, smallSettings, matte)) << "there is no highlight any more";
}

TEST(Dial, TellsWhatTheProbeMissed)
{
    DialAnswer answer;
    answer.best = Candidate{};
    answer.missed = {{"simd + no_highlight", 0.001, 0.4}};
    const auto words = sentencesOf(answer, within(0.02));
    EXPECT_EQ(words.back(), "The probe missed what simd + no_highlight loses: 0.001 there, 0.4 on the whole picture.");
}

TEST(Dial, SaysTheBestWhereNothingIsWithin)
{
    const auto answer = dialled(shinyScene(), {24, 24, 2}, within(1e-12), nullptr);
    ASSERT_TRUE(answer);
    EXPECT_FALSE(answer->chosen);
    ASSERT_TRUE(answer->best);
    EXPECT_GT(answer->best->error.max, 1e-12);
    EXPECT_THAT(sentencesOf(*answer, within(1e-12))[0], HasSubstr("the most exact that can be had is"));
}

TEST(Dial, KeepsWithinABudget)
{
    DialWish wish;
    wish.milliseconds = 1e6; // no machine is that slow, so the most exact must come out
    wish.probeSide = 16;
    const auto answer = dialled(shinyScene(), {24, 24, 2}, wish, nullptr);
    ASSERT_TRUE(answer);
    ASSERT_TRUE(answer->chosen);
    EXPECT_LT(answer->chosen->error.max, 1e-4) << "64 samples are the truth but for its arithmetic";
    wish.milliseconds = 1e-9;
    const auto none = dialled(shinyScene(), {24, 24, 2}, wish, nullptr);
    ASSERT_TRUE(none);
    EXPECT_FALSE(none->chosen);
    EXPECT_THAT(sentencesOf(*none, wish)[0], HasSubstr("the cheapest that can be had is"));
}

TEST(Dial, RefusesWishesThatNothingCouldMeet)
{
    for (const double tolerance : {-1e-9, std::nan(""), HUGE_VAL})
        EXPECT_FALSE(checkWish(within(tolerance))) << tolerance;
    for (const double milliseconds : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        DialWish wish;
        wish.milliseconds = milliseconds;
        EXPECT_FALSE(checkWish(wish)) << milliseconds;
    }
    EXPECT_FALSE(checkWish({})) << "neither";
    DialWish both = within(0.1);
    both.milliseconds = 1.0;
    EXPECT_FALSE(checkWish(both));
    EXPECT_TRUE(checkWish(within(0.0)));
}

} // namespace
} // namespace reflectance::test
