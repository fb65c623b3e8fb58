// The file of a run gives it back to the bit; a damaged one is refused with its line.
#include "core/base/text.h"
#include "core/study/goniometer/checkpoint.h"
#include "tests/study/goniometer/bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

LabRun someRun()
{
    LabSetup setup;
    setup.surface = "gaussian:sigma=20,seed=4";
    setup.model = "lambert_color";
    setup.values = {0.5, 0.1, 0, 0, 0.25, 0, 0, -0.1, 1.0 / 3.0};
    setup.channels = 9;
    setup.effects = {true, false, 7};
    setup.azimuth = 0.1;
    setup.shape = labShape(3, 2, false);
    setup.seed = 12345678901234567890U;
    LabRun run = startedRun(setup, 0xFFFFFFFFFFFFFFFFU);
    for (std::size_t i = 0; i < run.cells.size(); ++i) {
        run.cells[i].wanted = 9;
        for (std::size_t k = 0; k <= i % 3; ++k)
            run.cells[i].take({0.1 * static_cast<double>(k), 1.0 / 7.0, 1e-300, 4, 5, 6, 7, 8, 9}, 9);
    }
    return run;
}

std::string refusal(std::string text, const std::string& what, const std::string& by)
{
    text.replace(text.find(what), what.size(), by);
    const auto run = readCheckpoint(text, "run.lab");
    return run ? "" : run.error().sentence();
}

TEST(Checkpoint, GivesARunBackToTheBit)
{
    const std::string text = checkpointText(someRun());
    const auto run = readCheckpoint(text, "run.lab");
    ASSERT_TRUE(run) << run.error().sentence();
    EXPECT_EQ(checkpointText(*run), text);
    EXPECT_EQ(run->setup.effects, someRun().setup.effects);
}

TEST(Checkpoint, RefusesDamageWithItsLine)
{
    const std::string text = checkpointText(someRun());
    EXPECT_THAT(refusal(text, "goniometer 1", "goniometer 2"),
                testing::HasSubstr("run.lab:1: is no goniometer run of this version"));
    EXPECT_THAT(refusal(text, "model lambert_color\n", ""),
                testing::HasSubstr("run.lab:4: a line that begins with \"model\""));
    EXPECT_THAT(refusal(text, "channels 9", "channels 2"), testing::HasSubstr("\"channels\" cannot be \"2\""));
    EXPECT_THAT(refusal(text, "bounces 7", "bounces -7"), testing::HasSubstr("bounces"));
    EXPECT_THAT(refusal(text, "azimuth 0.1", "azimuth nan"), testing::HasSubstr("azimuth"));
    EXPECT_THAT(refusal(text, "cells 18", "cells 1800000000"), testing::HasSubstr("cells"));
    EXPECT_THAT(refusal(text, "theta_i 0", "theta_i 7"), testing::HasSubstr("cells")) << "angles that do not ascend";
    EXPECT_THAT(refusal(text, "1 9 0 ", "1 9 zero "), testing::HasSubstr("18 numbers"));
    EXPECT_THAT(readCheckpoint(text.substr(0, text.size() - 300), "run.lab").error().sentence(),
                testing::HasSubstr("run.lab:3"));
    EXPECT_THAT(readCheckpoint(text + "1 1\n", "run.lab").error().sentence(),
                testing::HasSubstr("goes on after its last cell"));
    EXPECT_FALSE(readCheckpoint("", "run.lab"));
}

} // namespace
} // namespace reflectance
