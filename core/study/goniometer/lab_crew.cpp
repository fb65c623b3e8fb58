#include "core/study/goniometer/lab_crew.h"

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/study/crew/foreman.h"
#include "core/study/crew/launch.h"
#include "core/study/crew/ranks.h"

#include <algorithm>
#include <memory>

namespace reflectance {
namespace {

/// Cells in one job: milliseconds of tracing, so that the way to another machine weighs little.
constexpr std::size_t cellsPerJob = 16;

/// A job: "CELL BATCH CELL BATCH ...". Its result: for each the channels and what was lost, all parted by blanks.
std::string batchesOf(std::string_view job, const LabSetup& setup, const MicroTracer& tracer)
{
    const auto numbers = words(job);
    std::string result;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        const auto cell = static_cast<std::size_t>(parseInteger(numbers[i]).value_or(0));
        const auto number = static_cast<std::uint64_t>(parseInteger(numbers[i + 1]).value_or(0));
        const LabBatch batch = tracedBatch(setup, tracer, cell, number);
        for (std::size_t c = 0; c < setup.channels; ++c)
            result += shortest(batch.f[c]) + " ";
        result += std::to_string(batch.lost) + " ";
    }
    return result;
}

/// One pass over cells, some at a time.
class Pass {
public:
    Pass(LabRun& run, const std::vector<std::size_t>& cells, std::size_t perJob, LabFailures& failures)
        : run_(run), cells_(cells), perJob_(perJob), failures_(failures)
    {
    }

    [[nodiscard]] Result<bool> by(Foreman& foreman, const std::function<bool()>& isStopped)
    {
        JobList jobs;
        jobs.end = (cells_.size() + perJob_ - 1) / perJob_;
        jobs.text = [this](std::uint64_t job) {
            std::string text;
            for (const std::size_t cell : cellsOf(job))
                text += std::to_string(cell) + " " + std::to_string(run_.cells[cell].batches) + " ";
            return text;
        };
        jobs.take = [this](std::uint64_t job, const JobOutcome& outcome) {
            const auto cells = cellsOf(job);
            if (outcome.failure.empty())
                take(cells, words(outcome.result));
            else if (cells.size() == 1)
                failures_[cells[0]] = outcome.failure;
            else
                suspects_.insert(suspects_.end(), cells.begin(), cells.end());
            return Result<void>();
        };
        return foreman.run(jobs, isStopped);
    }

    /// Cells of jobs that failed, of which one is to blame.
    [[nodiscard]] const std::vector<std::size_t>& suspects() const { return suspects_; }

private:
    [[nodiscard]] std::vector<std::size_t> cellsOf(std::uint64_t job) const
    {
        const std::size_t first = static_cast<std::size_t>(job) * perJob_;
        const std::size_t end = std::min(cells_.size(), first + perJob_);
        return {cells_.begin() + static_cast<std::ptrdiff_t>(first), cells_.begin() + static_cast<std::ptrdiff_t>(end)};
    }

    void take(const std::vector<std::size_t>& cells, const std::vector<std::string_view>& numbers)
    {
        const std::size_t channels = run_.setup.channels;
        CHECK_EQ(numbers.size(), cells.size() * (channels + 1));
        auto next = numbers.begin();
        for (const std::size_t cell : cells) {
            Channels f{};
            for (std::size_t c = 0; c < channels; ++c)
                f[c] = parseNumber(*next++).value_or(0.0);
            run_.cells[cell].take(f, channels);
            run_.lost += static_cast<std::uint64_t>(parseInteger(*next++).value_or(0));
        }
    }

    LabRun& run_;
    const std::vector<std::size_t>& cells_;
    std::size_t perJob_;
    LabFailures& failures_;
    std::vector<std::size_t> suspects_;
};

} // namespace

CrewWork labWork(const LabSetup& setup, const MicroTracer& tracer)
{
    return [&setup, &tracer](std::string_view job, Progress&) { return batchesOf(job, setup, tracer); };
}

LabPass passBy(Crew& crew, LabFailures& failures, Result<void>& problem)
{
    return [&, foreman = std::make_shared<Foreman>(crew)](LabRun& run, const std::vector<std::size_t>& cells,
                                                          const std::function<bool()>& isStopped) {
        Pass whole(run, cells, cellsPerJob, failures);
        auto goesOn = whole.by(*foreman, isStopped);
        if (goesOn && *goesOn && !whole.suspects().empty())
            goesOn = Pass(run, whole.suspects(), 1, failures).by(*foreman, isStopped);
        if (!goesOn)
            problem = goesOn.error();
        return goesOn && *goesOn;
    };
}

Result<LabFailures> measureWithCrew(LabRun& run, const MicroTracer& tracer, const LabTargets& targets, unsigned workers,
                                    Progress* progress, const LabWatch& watch)
{
    LabFailures failures;
    const auto ran = withCrew(handsFor(workers), labWork(run.setup, tracer), [&](Crew& crew) {
        Result<void> problem;
        measureInPasses(run, passBy(crew, failures, problem), failures, targets, progress, watch);
        return problem;
    });
    return ran ? Result<LabFailures>(failures) : ran.error();
}

} // namespace reflectance
