// A fit of a model to a measured file, as the workbench asks for it and gets it back. It runs on a thread of its own.
#pragma once

#include "core/measured/measurement.h"
#include "core/study/fit/fit.h"

#include <memory>
#include <optional>
#include <string>

namespace reflectance::explorer {

/// What is fitted to what.
struct FitWish {
    std::string file;
    int surface = 1; ///< which one of a file that holds several
    std::string model = "hybrid";
    bool logarithmic = false, cosine = true, robust = false;

    friend bool operator==(const FitWish&, const FitWish&) = default;
};

struct FitOutcome {
    FitWish wish;
    std::string problem; ///< a sentence; the rest is empty then
    Measurement measurement;
    Observations observations;
    FitResult fit;
};

/// Reads the file and fits; nothing where `progress` was cancelled.
[[nodiscard]] std::optional<FitOutcome> fittedAsWished(const FitWish& wish, Progress& progress);

/// The page's state.
struct FitStudy {
    FitWish wish;
    bool asked = false;   ///< the frame loop starts the fit
    bool stopped = false; ///< the frame loop gives it up
    bool running = false;
    double done = 0.0;
    std::shared_ptr<const FitOutcome> outcome;
    double thetaI = 30.0; ///< degrees: the light of the plot
};

} // namespace reflectance::explorer
