#include "core/study/sweep/sweep.h"

#include "core/study/crew/foreman.h"
#include "core/study/crew/launch.h"
#include "core/study/crew/ranks.h"
#include "core/study/sweep/cell_worker.h"

#include <charconv>
#include <chrono>
#include <filesystem>
#include <memory>
#include <unistd.h>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

Result<void> makeFolder(const std::string& folder)
{
    if (folder.empty())
        return {};
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed || !fs::is_directory(folder, failed) || ::access(folder.c_str(), W_OK | X_OK) != 0)
        return Error{"is no folder that pictures can be written to; choose another for --pictures", folder};
    return {};
}

std::uint64_t cellNamed(std::string_view job)
{
    std::uint64_t cell = 0;
    std::from_chars(job.data(), job.data() + job.size(), cell); // our own words
    return cell;
}

/// A worker comes to be in the process that works, with its first cell.
CrewWork workOf(const Study& study, const SweepOptions& options, unsigned hands)
{
    return [&study, options, hands, worker = std::shared_ptr<CellWorker>()](std::string_view job,
                                                                            Progress& progress) mutable {
        if (!worker)
            worker = std::make_shared<CellWorker>(study, options.pictures, threadsPerHand(hands));
        return resultText(worker->computed(cellAt(study, cellNamed(job)), &progress), options.timing);
    };
}

/// What the first rank does.
Result<SweepOutcome> lead(const Study& study, const SweepOptions& options, Progress* progress, Crew& crew)
{
    if (const auto ready = makeFolder(options.pictures); !ready)
        return ready.error();
    auto sheet = Sheet::open(options.out, study, options.timing);
    if (!sheet)
        return sheet.error();
    const std::uint64_t before = sheet->cellsDone(), cells = cellCount(study);
    JobList jobs;
    jobs.first = before;
    jobs.end = cells;
    jobs.text = [](std::uint64_t cell) { return std::to_string(cell); };
    jobs.take = [&](std::uint64_t cell, const JobOutcome& outcome) {
        if (progress)
            progress->done = static_cast<double>(cell + 1) / static_cast<double>(cells);
        return sheet->append(cellAt(study, cell), outcome.failure.empty()
                                                      ? outcome.result
                                                      : resultText({{}, outcome.failure}, options.timing));
    };
    const auto ran = Foreman(crew).run(jobs, [&] { return progress && progress->cancel; });
    if (!ran)
        return ran.error();
    if (!*ran)
        return Error{"stopped after " + std::to_string(sheet->cellsDone()) + " of " + std::to_string(cells) +
                     " cells; the same command goes on there"};
    return SweepOutcome{cells, before, sheet->cellsFailed()};
}

} // namespace

SweepEstimate estimated(const Study& study, const SweepOptions& options)
{
    const Cell first = cellAt(study, 0);
    const auto start = std::chrono::steady_clock::now();
    const CellResult result = CellWorker(study, "", handsFor(0)).computed(first);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double cells = static_cast<double>(cellCount(study));
    const double line = static_cast<double>((inputsOf(first) + resultText(result, options.timing)).size());
    // A PNG of a rendered object takes a byte a pixel or so: smooth shading compresses, a plain background costs nothing.
    const double picture =
        options.pictures.empty() ? 0.0 : static_cast<double>(first.settings.width) * first.settings.height;
    return {cells * seconds, cells * (line + picture)};
}

Result<SweepOutcome> sweep(const Study& study, const SweepOptions& options, Progress* progress)
{
    const unsigned hands = options.timing ? 1 : handsFor(options.workers);
    Result<SweepOutcome> outcome = SweepOutcome();
    const auto ran = withCrew(hands, workOf(study, options, hands), [&](Crew& crew) -> Result<void> {
        outcome = lead(study, options, progress, crew);
        return outcome ? Result<void>() : outcome.error();
    });
    return ran ? outcome : ran.error();
}

} // namespace reflectance
