// What each cheat costs on the user's own object: asked for on the page of colour, measured on a thread of its own.
#pragma once

#include "core/render/spectral/spectral_renderer.h"
#include "core/render/view_samples.h"

#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// The question, as values: nothing of the window is looked at while it is answered.
struct ObjectQuestion {
    Scene scene;
    ViewSamples samples;
    ColorSystem system;
    JudgedSurface surface;
    JudgedLight light; ///< in the span: lights are strengths of the primaries, else all have this spectrum
};

struct ObjectPrices {
    std::string surface, light;
    std::vector<PicturePrice> prices; ///< in the order of allCheats; empty where `problem` says why
    std::string problem;
};

/// The page's part of it.
struct ObjectStudy {
    bool asked = false;
    bool running = false;
    double done = 0.0;
    std::optional<ObjectPrices> found;
};

/// Every pixel of a view of at most some 20,000, else evenly spread ones: each is shaded wavelength by wavelength. Nothing where
/// cancelled.
[[nodiscard]] std::optional<ObjectPrices> objectPrices(const ObjectQuestion& question, Progress& progress);

} // namespace reflectance::explorer
