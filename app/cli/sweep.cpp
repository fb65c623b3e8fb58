// `sweep`: a grid of renders and their figures.
#include "core/study/sweep/sweep.h"

#include "app/cli/launched.h"
#include "app/cli/long_work.h"
#include "app/cli/report.h"
#include "app/cli/verbs.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/study/crew/ranks.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct Options {
    std::string study;
    SweepOptions sweep;
    bool yes = false;
    std::string json;
};

/// Above this many cells a sweep is asked for twice.
constexpr std::uint64_t manyCells = 10000;

std::string legible(double value, const std::vector<std::pair<double, const char*>>& units)
{
    std::size_t unit = 0;
    while (unit + 1 < units.size() && value >= units[unit + 1].first)
        ++unit;
    return general(value / units[unit].first, 2) + " " + units[unit].second;
}

Result<void> checkMany(const Options& options, const Study& study)
{
    const std::uint64_t cells = cellCount(study);
    if (cells <= manyCells || options.yes)
        return {};
    if (isHelper())
        return Error{"too many cells; the first rank says more"};
    const SweepEstimate cost = estimated(study, options.sweep);
    return Error{
        "the study has " + std::to_string(cells) + " cells, which take about " +
            legible(
                cost.seconds,
                {{1.0, "seconds"}, {60.0, "minutes"}, {3600.0, "hours"}, {86400.0, "days"}, {31557600.0, "years"}}) +
            " and " + legible(cost.bytes, {{1e6, "MB"}, {1e9, "GB"}, {1e12, "TB"}, {1e15, "PB"}}) +
            " on this machine; give --yes to go ahead",
        options.study};
}

Result<void> checkTimed(const Options& options)
{
    const auto ranks = ranksHere();
    if (options.sweep.timing && ranks && ranks->areMany)
        return Error{"--timing: cells are timed one after the other, so leave mpirun away"};
    return {};
}

int run(const Options& options)
{
    if (const auto code = refusedLaunch())
        return *code;
    if (const auto timed = checkTimed(options); !timed)
        return refusedHere(timed.error(), BadInput);
    if (!options.json.empty() && options.json != "-")
        if (const auto writable = checkWritable(options.json); !writable)
            return refused(writable.error());
    const auto study = loadStudy(options.study);
    if (!study)
        return refusedHere(study.error(), BadInput);
    if (const auto agreed = checkMany(options, *study); !agreed)
        return refusedHere(agreed.error(), BadInput);
    const auto done = [&] {
        const LongWork work;
        return sweep(*study, options.sweep, &LongWork::progress());
    }();
    if (!done)
        return refusedHere(done.error(), LongWork::wasStopped() ? Stopped : BadInput);
    if (isHelper())
        return Done;
    if (const auto written = writeReport(options.json, {{"cells", done->cells},
                                                        {"computed", done->cells - done->before},
                                                        {"already_there", done->before},
                                                        {"failed", done->failed}});
        !written)
        return refused(written.error());
    std::cerr << options.sweep.out << ": " << done->cells << " cells, " << done->before << " of them from before";
    if (done->failed > 0)
        std::cerr << "; " << done->failed << " could not be computed, the column error says why";
    std::cerr << '\n';
    return done->failed > 0 ? DoesNotHold : Done;
}

} // namespace

void addSweep(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand(
        "sweep",
        "A grid of renders: models, parameters, meshes, views, lights, renderers, sizes; figures to CSV. Stopped or "
        "killed, the same command goes on where it was");
    verb->add_option("study", options->study, "study (.json): a base scene and axes; docs/sweeps.md describes it")
        ->required();
    verb->add_option("--out", options->sweep.out, "figures (.csv), one line a cell; lines that are there are kept")
        ->required();
    verb->add_option("--pictures", options->sweep.pictures, "folder for a picture of every cell, cell_0.png and so on");
    verb->add_flag("--timing", options->sweep.timing,
                   "a column of milliseconds per shading; cells then run one after the other");
    verb->add_option("--workers", options->sweep.workers,
                     "processes with a cell at a time, under mpirun in every rank; 0: one per core")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    verb->add_flag("--yes", options->yes, "go ahead with more than 10000 cells");
    verb->add_option("--json", options->json, "counts, to a file or - for standard output");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
