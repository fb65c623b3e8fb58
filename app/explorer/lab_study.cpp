#include "app/explorer/lab_study.h"

#include <chrono>
#include <cmath>

namespace reflectance::explorer {

namespace {

/// Ten degrees from one another, 15 of azimuth: finer ones take minutes.
constexpr std::size_t thetas = 10, phis = 13;
constexpr std::chrono::milliseconds between{150};

struct Bench {
    MicroSurface surface;
    Facets facets;
};

Result<Bench> benchFor(const LabWish& wish)
{
    const auto model = findModel(wish.model);
    if (!model)
        return model.error();
    auto facets = facetsOf(**model, flatValues((*model)->text, wish.values));
    if (!facets)
        return facets.error();
    auto surface = microSurface(wish.surface);
    if (!surface)
        return surface.error();
    return Bench{*std::move(surface), *std::move(facets)};
}

LabRun freshRun(const LabWish& wish, const Bench& bench)
{
    LabSetup setup;
    setup.surface = wish.surface;
    setup.model = wish.model;
    setup.values = bench.facets.values;
    setup.channels = bench.facets.channels;
    setup.effects.bounces = static_cast<int>(std::lround(wish.bounces));
    setup.shape = labShape(thetas, phis, true);
    return startedRun(std::move(setup), bench.surface.fingerprint());
}

} // namespace

void LabLive::show(std::shared_ptr<const LabRun> run)
{
    const std::scoped_lock lock(mutex_);
    latest_ = std::move(run);
}

std::shared_ptr<const LabRun> LabLive::latest() const
{
    const std::scoped_lock lock(mutex_);
    return latest_;
}

std::optional<LabOutcome> measuredAsWished(const LabWish& wish, std::shared_ptr<const LabRun> from, LabLive& live,
                                           const std::function<void()>& wake, Progress& progress)
{
    const auto bench = benchFor(wish);
    if (!bench)
        return LabOutcome{bench.error().sentence()};
    LabRun run = from ? *from : freshRun(wish, *bench);
    if (run.fingerprint != bench->surface.fingerprint())
        return LabOutcome{"The file of the micro-surface has changed; begin a new run."};
    from.reset();
    const MicroTracer tracer(bench->surface, bench->facets, run.setup.effects);
    LabTargets targets;
    targets.paths = 1024;
    targets.error = wish.error;
    auto shown = std::chrono::steady_clock::time_point();
    measure(run, tracer, targets, &progress, [&](const LabRun& now) {
        if (std::chrono::steady_clock::now() - shown < between)
            return;
        live.show(std::make_shared<const LabRun>(now));
        wake();
        shown = std::chrono::steady_clock::now();
    });
    live.show(std::make_shared<const LabRun>(std::move(run)));
    return progress.cancel ? std::nullopt : std::optional(LabOutcome());
}

bool LabStudy::canGoOn() const
{
    LabWish other = measured;
    other.error = wish.error;
    return run && other == wish;
}

} // namespace reflectance::explorer
