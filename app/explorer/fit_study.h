// A fit of a model to a measured file, or to a picture of the scene's mesh, as the workbench asks for it and gets it back. It
// runs on a thread of its own.
#pragma once

#include "core/measured/measurement.h"
#include "core/study/fit/fit.h"
#include "core/study/fit/picture_observations.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// A photograph or a render of the scene's mesh under its lights.
struct Photograph {
    std::string file;
    std::string problem; ///< a sentence; the rest is empty then
    Picture picture;
    Developed shown; ///< as the scene's sensor shows it; a PNG as it is
};

/// Nothing where `progress` was cancelled.
[[nodiscard]] std::optional<Photograph> photographFrom(const std::string& file, const Sensor& sensor,
                                                       const Progress& progress);

/// What is fitted to what.
struct FitWish {
    bool fromPicture = false; ///< to the photograph's pixels instead of the measured file
    std::string file;
    int surface = 1; ///< which one of a file that holds several
    std::shared_ptr<const Photograph> photograph = {};
    std::shared_ptr<const Scene> scene = {}; ///< whose mesh, camera and lights the photograph shows
    std::vector<PixelPlace> pixels = {};     ///< those to look at; empty: all that see the object whole and lit
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
    std::string pictureFile; ///< as typed; it is read when the field is left
    bool readPicture = false;
    unsigned pictureTexture = 0; ///< of wish.photograph
    double thetaI = 30.0;        ///< degrees: the light of the plot
};

} // namespace reflectance::explorer
