// The price of each cheat on a whole picture of the user's object.
#pragma once

#include "core/render/settings.h"
#include "core/render/spectral/spectral_renderer.h"

namespace reflectance::cli {

/// The cheats' prices under one kind of light.
struct ObjectPrices {
    std::string light; ///< "as in the scene", or the spectrum that all its lights took
    std::vector<PicturePrice> prices;
};

/// The scene's lights as strengths of the primaries, then with the spectrum of each light beyond them. Shows progress on
/// a terminal; a stop by the user is an error.
[[nodiscard]] Result<std::vector<ObjectPrices>> pricesOnObject(const Scene& scene, const RenderSettings& settings,
                                                               const ColorSystem& system, const JudgedSurface& surface,
                                                               const std::vector<JudgedLight>& lights);

} // namespace reflectance::cli
