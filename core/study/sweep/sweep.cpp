#include "core/study/sweep/sweep.h"

#include "core/sensor/picture.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>
#include <unistd.h>
#include <vector>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

/// How far the fastest worker may be ahead of the slowest, in cells per worker: what a kill can lose.
constexpr std::uint64_t lead = 8;

std::string picturePath(const std::string& folder, std::uint64_t cell)
{
    return (fs::path(folder) / ("cell_" + std::to_string(cell) + ".png")).string();
}

unsigned workersFor(const SweepOptions& options)
{
    if (options.timing)
        return 1;
    return options.workers > 0 ? options.workers : std::max(1U, std::thread::hardware_concurrency());
}

/// Cells handed out in order, results taken in any.
class Team {
public:
    Team(const Study& study, const SweepOptions& options, Sheet& sheet, Progress* progress)
        : study_(study), options_(options), sheet_(sheet), inOrder_(study, sheet), progress_(progress),
          next_(sheet.cellsDone()), count_(cellCount(study)), window_(lead * workersFor(options))
    {
    }

    Result<void> run()
    {
        {
            std::vector<std::jthread> workers;
            for (unsigned i = 0; i < workersFor(options_); ++i)
                workers.emplace_back([this] { work(); });
        }
        return problem_;
    }

private:
    void work()
    {
        while (const auto index = take()) {
            const Cell cell = cellAt(study_, *index);
            auto result = workOn(cell, study_, options_, progress_);
            if (!result)
                return stop({});
            give(*index, *std::move(result));
        }
    }

    std::optional<std::uint64_t> take()
    {
        std::unique_lock lock(mutex_);
        moved_.wait(lock, [this] { return stopped_ || next_ == count_ || next_ < sheet_.cellsDone() + window_; });
        if (stopped_ || next_ == count_ || (progress_ && progress_->cancel))
            return std::nullopt;
        return next_++;
    }

    void give(std::uint64_t index, CellResult result)
    {
        const std::scoped_lock lock(mutex_);
        if (!problem_)
            return;
        problem_ = inOrder_.take(index, std::move(result));
        stopped_ = stopped_ || !problem_;
        if (progress_)
            progress_->done = static_cast<double>(sheet_.cellsDone()) / static_cast<double>(count_);
        moved_.notify_all();
    }

    void stop(Result<void> why)
    {
        const std::scoped_lock lock(mutex_);
        stopped_ = true;
        if (!why)
            problem_ = std::move(why);
        moved_.notify_all();
    }

    const Study& study_;
    const SweepOptions& options_;
    Sheet& sheet_;
    InOrder inOrder_;
    Progress* progress_;
    std::mutex mutex_;
    std::condition_variable moved_;
    std::uint64_t next_, count_, window_;
    bool stopped_ = false;
    Result<void> problem_;
};

CellResult computed(const Cell& cell, const Study& study, const SweepOptions& options, Progress* progress)
{
    const auto done = computeCell(cell, study.folder, progress);
    if (!done)
        return {{}, done.error().sentence()};
    if (!options.pictures.empty())
        if (const auto saved = savePicture(picturePath(options.pictures, cell.index), done->image, done->sensor);
            !saved)
            return {{}, saved.error().sentence()};
    return {done->figures, ""};
}

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

} // namespace

std::optional<CellResult> workOn(const Cell& cell, const Study& study, const SweepOptions& options, Progress* progress)
{
    CellResult result;
    try {
        result = computed(cell, study, options, progress);
    } catch (const std::bad_alloc&) {
        result.error = "out of memory; try a smaller mesh, picture or number of samples";
    } catch (const std::exception& problem) {
        result.error = problem.what();
    }
    if (progress && progress->cancel)
        return std::nullopt;
    return result;
}

Result<void> InOrder::take(std::uint64_t cell, CellResult result)
{
    waiting_.emplace(cell, std::move(result));
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == sheet_->cellsDone();
         first = waiting_.erase(first))
        if (auto written = sheet_->append(cellAt(*study_, first->first), first->second); !written)
            return written;
    return {};
}

SweepEstimate estimated(const Study& study, const SweepOptions& options)
{
    const Cell first = cellAt(study, 0);
    const auto start = std::chrono::steady_clock::now();
    SweepOptions dry = options;
    dry.pictures = "";
    const auto result = workOn(first, study, dry, nullptr);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double cells = static_cast<double>(cellCount(study));
    const double line =
        static_cast<double>((inputsOf(first) + resultText(result.value_or(CellResult()), options.timing)).size());
    // A PNG of a rendered object takes a byte a pixel or so: smooth shading compresses, a plain background costs nothing.
    const double picture =
        options.pictures.empty() ? 0.0 : static_cast<double>(first.settings.width) * first.settings.height;
    return {cells * seconds, cells * (line + picture)};
}

Result<SweepOutcome> sweep(const Study& study, const SweepOptions& options, Progress* progress)
{
    if (const auto ready = makeFolder(options.pictures); !ready)
        return ready.error();
    auto sheet = Sheet::open(options.out, study, options.timing);
    if (!sheet)
        return sheet.error();
    const std::uint64_t before = sheet->cellsDone();
    if (const auto ran = Team(study, options, *sheet, progress).run(); !ran)
        return ran.error();
    if (sheet->cellsDone() < cellCount(study))
        return Error{"stopped after " + std::to_string(sheet->cellsDone()) + " of " + std::to_string(cellCount(study)) +
                     " cells; the same command goes on there"};
    return SweepOutcome{cellCount(study), before, sheet->cellsFailed()};
}

} // namespace reflectance
