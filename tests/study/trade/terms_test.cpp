#include "core/study/trade/terms.h"
#include "tests/study/trade/scenes.h"

#include <gmock/gmock.h>

namespace reflectance::test {
namespace {

std::vector<std::string> namesOf(const Scene& scene)
{
    std::vector<std::string> names;
    for (const Term& term : termsOf(scene))
        names.push_back(term.name);
    return names;
}

TEST(Terms, AreThoseThatTheSceneHas)
{
    Scene scene = shinyScene();
    EXPECT_THAT(namesOf(scene), testing::ElementsAre("diffuse", "specular", "off-diagonal K", "colour of K",
                                                     "light 'light'", "light 'faint'", "light 'lamp'"));
    scene.surface.model = "oren_nayar_full";
    scene.lights.resize(1);
    EXPECT_THAT(namesOf(scene), testing::ElementsAre("interreflection", "roughness", "light 'light'"));
    scene.lights[0].on = false;
    scene.surface.model = "mirror";
    scene.environment.kind = EnvironmentKind::Studio;
    EXPECT_THAT(namesOf(scene), testing::ElementsAre("surroundings"));
}

TEST(Terms, BuyWhatTheyAdd)
{
    const auto bars = termBars(shinyScene(), smallSettings, 1);
    ASSERT_TRUE(bars);
    EXPECT_EQ(bars->whole.repetitions, 7); // one before each term
    for (const TermFigures& term : bars->terms)
        EXPECT_GT(term.buys.max, 0.0) << term.name;
    // The planted fault: a light of 1/1000 buys next to nothing, the key nearly all.
    EXPECT_LT(bars->terms[5].buys.perceived.deltaEMax, 1.0);
    EXPECT_GT(bars->terms[4].buys.perceived.deltaEMax, 10.0);
}

TEST(Terms, StopWhenAsked)
{
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(termBars(shinyScene(), smallSettings, 1, &progress));
}

} // namespace
} // namespace reflectance::test
