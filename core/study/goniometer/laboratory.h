// The virtual goniometer: a micro-surface measured from all lighting and viewing directions into a table, with the standard
// error of every cell. A run is a value: it can be stopped anywhere, kept in a file, and taken up again.
#pragma once

#include "core/base/result.h"
#include "core/measured/resample.h"
#include "core/render/progress.h"
#include "core/study/goniometer/micro_tracer.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace reflectance {

/// Everything that the numbers depend on.
struct LabSetup {
    std::string surface = "vgrooves:sigma=30"; ///< as microSurface takes it
    std::string model = "lambert";             ///< of the facets
    std::vector<double> values;                ///< its flat list
    std::size_t channels = 1;                  ///< 1, 3 or 9
    Effects effects;
    std::optional<double>
        azimuth;     ///< radians by which the surface lies turned; none: an isotropic mixture of all angles
    GridShape shape; ///< Isotropic: theta_i, theta_r, delta_phi
    std::uint64_t seed = 1;
};

/// theta_i and theta_r in even steps to 90 degrees, delta_phi to 180; all the way round to 360 for a surface that lies still.
[[nodiscard]] GridShape labShape(std::size_t thetas, std::size_t phis, bool isMixed);

/// Facets of a model, for a setup. Refused: a model that shows a light's disc (a mirror has no BRDF), and the table, which needs a
/// file of its own.
[[nodiscard]] Result<Facets> facetsOf(const Model& model, std::vector<double> values);

/// Of f in 1/sr, over the batches so far (Welford 1962). `wanted` batches are to be done before anything else is planned, so
/// that a run that was stopped goes on as if it had not been.
struct LabCell {
    std::uint64_t batches = 0, wanted = 0;
    Channels mean{}, squares{}; ///< squares: sum of squared deviations from the mean

    void take(const Channels& f, std::size_t channels);
    /// Of the mean; infinite below two batches.
    [[nodiscard]] double standardError(std::size_t channel) const;
};

struct LabRun {
    LabSetup setup;
    std::uint64_t fingerprint = 0; ///< of the micro-surface
    std::vector<LabCell> cells;    ///< delta_phi fastest, theta_i slowest
    std::uint64_t lost = 0;        ///< rays that fell through the surface

    [[nodiscard]] std::uint64_t paths() const;
};

[[nodiscard]] LabRun startedRun(LabSetup setup, std::uint64_t fingerprint);

/// When to stop. All cells get `paths`; then those whose error is above `error` get more. With a time and no error the quarter
/// with the largest errors gets twice as many, round after round.
struct LabTargets {
    std::uint64_t paths = 4096;  ///< per cell, in whole batches, at least 4 of them
    std::optional<double> error; ///< largest standard error of a cell, over the root mean square of f over all cells
    std::optional<double> seconds;
    std::uint64_t mostPaths = 1U << 24U; ///< per cell: an error that cannot be reached ends here
};

/// Called now and then between passes, from the thread that called measure.
using LabWatch = std::function<void(const LabRun&)>;

/// Measures until the targets are reached, the time is over or `progress` is cancelled. The numbers depend on setup and
/// targets alone, not on threads, nor on where a run was stopped (but for a time limit, which knows how fast the machine is).
/// Directions closer than half a degree to the horizon are measured there.
void measure(LabRun& run, const MicroTracer& tracer, const LabTargets& targets, Progress* progress = nullptr,
             const LabWatch& watch = {});

/// Cells without a batch are holes.
[[nodiscard]] Table tableOf(const LabRun& run);
/// The same grid, holding the standard error of f; holes below two batches.
[[nodiscard]] Table errorsOf(const LabRun& run);

/// As LabTargets::error counts it.
struct LabErrors {
    double typical = 0.0, largest = 0.0;
    std::size_t worstCell = 0;
};
[[nodiscard]] LabErrors errorsFound(const LabRun& run);

/// Directions of a cell, as they are measured.
[[nodiscard]] DirectionPair directionsOf(const LabSetup& setup, std::size_t cell);

} // namespace reflectance
