#include "core/study/goniometer/laboratory.h"

#include "core/math/angle.h"
#include "core/math/matrix3.h"
#include "core/render/cpu/in_parallel.h"
#include "core/study/goniometer/lab_pass.h"
#include "core/study/tables/sample_model.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

namespace reflectance {
namespace {

constexpr std::uint64_t fewestBatches = 4; ///< fewer tell no error

using Clock = std::chrono::steady_clock;

std::uint64_t batchesOf(std::uint64_t paths)
{
    return std::max(fewestBatches, (paths + MicroTracer::batchSize - 1) / MicroTracer::batchSize);
}

std::size_t entryOf(std::size_t channel, std::size_t channels)
{
    return channels == 9 ? channel : 4 * channel;
}

/// Root mean square of f over the measured cells, mean of the channels.
double scaleOf(const LabRun& run)
{
    double sum = 0.0;
    double count = 0.0;
    for (const LabCell& cell : run.cells)
        for (std::size_t c = 0; cell.batches > 0 && c < run.setup.channels; ++c) {
            sum += cell.mean[c] * cell.mean[c];
            count += 1.0;
        }
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

/// Largest standard error over the channels, on that scale.
double errorOf(const LabRun& run, const LabCell& cell, double scale)
{
    double worst = 0.0;
    for (std::size_t c = 0; c < run.setup.channels; ++c)
        worst = std::max(worst, cell.standardError(c));
    return worst == 0.0 ? 0.0 : worst / scale;
}

/// Gives cells whose error is too large what the square root law says, at most four times what they have.
bool planForError(LabRun& run, double wanted, std::uint64_t most)
{
    const double scale = scaleOf(run);
    bool any = false;
    for (LabCell& cell : run.cells) {
        const double error = errorOf(run, cell, scale);
        if (!(error > wanted) || cell.batches >= most)
            continue;
        const double growth = std::clamp(1.1 * (error / wanted) * (error / wanted), 1.25, 4.0);
        cell.wanted = std::min(
            most, cell.batches + std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(
                                                                (growth - 1.0) * static_cast<double>(cell.batches)))));
        any = true;
    }
    return any;
}

/// Doubles the quarter with the largest errors.
bool planForTime(LabRun& run, std::uint64_t most)
{
    const double scale = scaleOf(run);
    std::vector<double> errors;
    for (const LabCell& cell : run.cells)
        errors.push_back(errorOf(run, cell, scale));
    std::vector<double> sorted = errors;
    std::sort(sorted.begin(), sorted.end());
    const double bound = sorted[sorted.size() * 3 / 4];
    bool any = false;
    for (std::size_t i = 0; i < run.cells.size(); ++i)
        if (errors[i] >= bound && errors[i] > 0.0 && run.cells[i].batches < most) {
            run.cells[i].wanted = std::min(most, 2 * run.cells[i].batches);
            any = true;
        }
    return any;
}

/// The next cells to measure more of; false when nothing is left to do.
bool plan(LabRun& run, const LabTargets& targets)
{
    const std::uint64_t least = batchesOf(targets.paths);
    bool any = false;
    for (LabCell& cell : run.cells) {
        if (cell.batches < least) {
            cell.wanted = least;
            any = true;
        }
    }
    if (any)
        return true;
    const std::uint64_t most = std::max(least, targets.mostPaths / MicroTracer::batchSize);
    if (targets.error)
        return planForError(run, *targets.error, most);
    return targets.seconds && planForTime(run, most);
}

double shareDone(const LabRun& run)
{
    double done = 0.0;
    double wanted = 0.0;
    for (const LabCell& cell : run.cells) {
        done += static_cast<double>(cell.batches);
        wanted += static_cast<double>(std::max(cell.wanted, cell.batches));
    }
    return wanted > 0.0 ? done / wanted : 1.0;
}

std::vector<std::size_t> waitingCells(const LabRun& run, const LabFailures& failures)
{
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < run.cells.size(); ++i)
        if (run.cells[i].batches < run.cells[i].wanted && !failures.contains(i))
            waiting.push_back(i);
    return waiting;
}

Table gridOfRun(const LabRun& run)
{
    Table table;
    table.system = AngleSystem::Isotropic;
    table.axes = run.setup.shape.axes;
    table.channels = run.setup.channels;
    table.provenance.name = run.setup.surface + ", facets " + run.setup.model;
    table.provenance.format = "virtual goniometer";
    table.provenance.convention = "BRDF in 1/sr";
    table.provenance.samples = run.cells.size();
    return table;
}

} // namespace

GridShape labShape(std::size_t thetas, std::size_t phis, bool isMixed)
{
    GridShape shape = isotropicShape(thetas, phis);
    if (!isMixed)
        for (double& phi : shape.axes[2])
            phi *= 2.0;
    return shape;
}

Result<Facets> facetsOf(const Model& model, std::vector<double> values)
{
    if (model.text.usesLightSize)
        return Error{"facets of the model " + model.id() +
                     " show the light itself, which no BRDF measures; choose another model"};
    if (model.text.usesTable)
        return Error{"facets cannot be a measured table; choose a model with a formula"};
    const std::size_t channels = channelsOf(model, values);
    return Facets{&model, std::move(values), channels};
}

void LabCell::take(const Channels& f, std::size_t channels)
{
    ++batches;
    for (std::size_t c = 0; c < channels; ++c) {
        const double before = f[c] - mean[c];
        mean[c] += before / static_cast<double>(batches);
        squares[c] += before * (f[c] - mean[c]);
    }
}

double LabCell::standardError(std::size_t channel) const
{
    const auto n = static_cast<double>(batches);
    return batches < 2 ? std::numeric_limits<double>::infinity()
                       : std::sqrt(std::max(0.0, squares[channel]) / (n * (n - 1.0)));
}

std::uint64_t LabRun::paths() const
{
    std::uint64_t batches = 0;
    for (const LabCell& cell : cells)
        batches += cell.batches;
    return batches * MicroTracer::batchSize;
}

LabRun startedRun(LabSetup setup, std::uint64_t fingerprint)
{
    LabRun run;
    run.cells.resize(setup.shape.samples());
    run.setup = std::move(setup);
    run.fingerprint = fingerprint;
    return run;
}

LabBatch tracedBatch(const LabSetup& setup, const MicroTracer& tracer, std::size_t cell, std::uint64_t batch)
{
    const DirectionPair directions = directionsOf(setup, cell);
    const MicroTracer::Batch traced = tracer.trace(directions, setup.azimuth, CounterRandom(setup.seed, cell, batch));
    const auto numbers = rowByRow(traced.factor);
    LabBatch result;
    for (std::size_t c = 0; c < setup.channels; ++c)
        result.f[c] = numbers[entryOf(c, setup.channels)] / (std::numbers::pi * directions.L.z);
    result.lost = traced.lost;
    return result;
}

void measureInPasses(LabRun& run, const LabPass& pass, const LabFailures& failures, const LabTargets& targets,
                     Progress* progress, const LabWatch& watch)
{
    const auto begin = Clock::now();
    const auto isStopped = [&] {
        return (progress && progress->cancel) ||
               (targets.seconds && std::chrono::duration<double>(Clock::now() - begin).count() >= *targets.seconds);
    };
    for (;;) {
        std::vector<std::size_t> waiting = waitingCells(run, failures);
        if (waiting.empty() && !isStopped() && plan(run, targets))
            waiting = waitingCells(run, failures);
        if (waiting.empty() || isStopped())
            break;
        // One batch each: whoever watches or stops a run does not wait long.
        const bool goesOn = pass(run, waiting, isStopped);
        if (progress)
            progress->done = shareDone(run);
        if (watch)
            watch(run);
        if (!goesOn)
            break;
    }
}

void measure(LabRun& run, const MicroTracer& tracer, const LabTargets& targets, Progress* progress,
             const LabWatch& watch)
{
    const auto onThreads = [&tracer](LabRun& of, const std::vector<std::size_t>& cells,
                                     const std::function<bool()>& isStopped) {
        std::atomic<std::uint64_t> lost{0};
        inParallel(std::size_t{0}, cells.size(), [&](std::size_t k) {
            if (isStopped())
                return;
            LabCell& cell = of.cells[cells[k]];
            const LabBatch batch = tracedBatch(of.setup, tracer, cells[k], cell.batches);
            cell.take(batch.f, of.setup.channels);
            lost += batch.lost;
        });
        of.lost += lost;
        return !isStopped();
    };
    measureInPasses(run, onThreads, {}, targets, progress, watch);
}

Table tableOf(const LabRun& run)
{
    Table table = gridOfRun(run);
    for (const LabCell& cell : run.cells)
        for (std::size_t c = 0; c < run.setup.channels; ++c)
            table.values.push_back(cell.batches > 0 ? cell.mean[c] : std::numeric_limits<double>::quiet_NaN());
    return table;
}

Table errorsOf(const LabRun& run)
{
    Table table = gridOfRun(run);
    table.provenance.name += ", standard error";
    for (const LabCell& cell : run.cells)
        for (std::size_t c = 0; c < run.setup.channels; ++c)
            table.values.push_back(cell.batches > 1 ? cell.standardError(c) : std::numeric_limits<double>::quiet_NaN());
    return table;
}

LabErrors errorsFound(const LabRun& run)
{
    const double scale = scaleOf(run);
    LabErrors found;
    double sum = 0.0;
    for (std::size_t i = 0; i < run.cells.size(); ++i) {
        const double error = errorOf(run, run.cells[i], scale);
        sum += error * error;
        if (error > found.largest) {
            found.largest = error;
            found.worstCell = i;
        }
    }
    found.typical = std::sqrt(sum / static_cast<double>(run.cells.size()));
    return found;
}

DirectionPair directionsOf(const LabSetup& setup, std::size_t cell)
{
    const auto& axes = setup.shape.axes;
    const double highest = radians(89.5);
    const double deltaPhi = axes[2][cell % axes[2].size()];
    const double thetaR = axes[1][cell / axes[2].size() % axes[1].size()];
    const double thetaI = axes[0][cell / axes[2].size() / axes[1].size()];
    return directionsAt(AngleSystem::Isotropic, {std::min(thetaI, highest), std::min(thetaR, highest), deltaPhi});
}

} // namespace reflectance
