// The virtual goniometer as the workbench asks for it: what is measured, a run that goes on in the background, and how it stands.
#pragma once

#include "core/reflectance/catalogue.h"
#include "core/study/goniometer/laboratory.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace reflectance::explorer {

/// What is measured.
struct LabWish {
    std::string surface = "vgrooves:sigma=30";
    std::string model = "lambert"; ///< of the facets
    ParameterValues values{{"kd", {0.9}}};
    double bounces = 3.0;
    double error = 0.01; ///< as LabTargets::error

    friend bool operator==(const LabWish&, const LabWish&) = default;
};

/// Between the thread that measures and the frames that show: the run as it was after its last pass.
class LabLive {
public:
    void show(std::shared_ptr<const LabRun> run);
    [[nodiscard]] std::shared_ptr<const LabRun> latest() const;

private:
    mutable std::mutex mutex_;
    std::shared_ptr<const LabRun> latest_;
};

struct LabOutcome {
    std::string problem; ///< a sentence; empty where the run reached its error
};

/// Measures as wished, from the start or going on with `from`, and shows the run in `live` several times a second; `wake` is
/// called then. Nothing where `progress` was cancelled: what was measured until then is in `live`.
[[nodiscard]] std::optional<LabOutcome> measuredAsWished(const LabWish& wish, std::shared_ptr<const LabRun> from,
                                                         LabLive& live, const std::function<void()>& wake,
                                                         Progress& progress);

/// The page's state.
struct LabStudy {
    LabWish wish;
    LabWish measured;     ///< what `run` is of
    bool asked = false;   ///< the frame loop starts the run, or goes on with it
    bool stopped = false; ///< the frame loop stops it; what was measured stays
    bool running = false;
    double done = 0.0;
    std::string problem;
    std::shared_ptr<const LabRun> run; ///< as far as it is; null before the first pass
    double thetaI = 60.0;              ///< degrees: the light of the plots

    /// Whether the run on show can go on under the wish: only how far it goes may differ.
    [[nodiscard]] bool canGoOn() const;
};

} // namespace reflectance::explorer
