// Processes that trace: the numbers of threads to the last bit, and a cell that kills them is found and left alone.
#include "core/study/crew/local_crew.h"
#include "core/study/goniometer/checkpoint.h"
#include "core/study/goniometer/lab_crew.h"
#include "tests/study/goniometer/bench.h"

#include <csignal>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

struct Lab {
    LabSetup setup;
    MicroSurface surface;
    MicroTracer tracer;

    Lab()
        : setup(setupOfGrooves()), surface(*microSurface(setup.surface)),
          tracer(surface, facetsNamed("lambert", {{"kd", {1.0}}}), setup.effects)
    {
    }
    [[nodiscard]] LabRun start() const { return startedRun(setup, surface.fingerprint()); }

private:
    static LabSetup setupOfGrooves()
    {
        LabSetup made;
        made.surface = "vgrooves:slope=40";
        made.values = {1.0};
        made.effects.bounces = 1;
        made.shape = labShape(4, 4, true);
        return made;
    }
};

const LabTargets twoRounds{1024, 0.05, {}};

TEST(LabCrew, ProcessesGiveTheNumbersOfThreads)
{
    const Lab lab;
    LabRun byThreads = lab.start();
    measure(byThreads, lab.tracer, twoRounds);
    for (const unsigned workers : {1U, 3U}) {
        LabRun run = lab.start();
        const auto measured = measureWithCrew(run, lab.tracer, twoRounds, workers);
        ASSERT_TRUE(measured) << measured.error().sentence();
        EXPECT_TRUE(measured->empty());
        EXPECT_EQ(checkpointText(run), checkpointText(byThreads)) << workers;
    }
}

TEST(LabCrew, AStoppedRunGoesOnAsIfItHadNotBeen)
{
    const Lab lab;
    LabRun whole = lab.start();
    measure(whole, lab.tracer, twoRounds);
    LabRun run = lab.start();
    Progress progress;
    const auto stopped =
        measureWithCrew(run, lab.tracer, twoRounds, 2, &progress, [&](const LabRun&) { progress.cancel = true; });
    ASSERT_TRUE(stopped);
    EXPECT_LT(run.paths(), whole.paths());
    ASSERT_TRUE(measureWithCrew(run, lab.tracer, twoRounds, 2));
    EXPECT_EQ(checkpointText(run), checkpointText(whole));
}

/// The planted fault: cell 21 kills whoever traces it.
TEST(LabCrew, ACellThatKillsIsFoundAndLeftAlone)
{
    constexpr std::size_t deadly = 21;
    const Lab lab;
    LabRun whole = lab.start();
    measure(whole, lab.tracer, twoRounds);
    LabRun run = lab.start();
    const auto crew = LocalCrew::create(2, [&](std::string_view job, Progress& progress) {
        if ((" " + std::string(job)).find(" " + std::to_string(deadly) + " 0 ") != std::string::npos)
            std::raise(SIGKILL);
        return labWork(lab.setup, lab.tracer)(job, progress);
    });
    ASSERT_TRUE(crew);
    LabFailures failures;
    Result<void> problem;
    measureInPasses(run, passBy(**crew, failures, problem), failures, {1024, {}, {}}, nullptr, {});
    EXPECT_TRUE(problem);
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_NE(failures.at(deadly).find("was killed"), std::string::npos);
    for (std::size_t cell = 0; cell < run.cells.size(); ++cell)
        EXPECT_EQ(run.cells[cell].batches, cell == deadly ? 0U : 4U) << cell;
}

} // namespace
} // namespace reflectance
