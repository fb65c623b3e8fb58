// Which model suffices where: each pixel belongs to the cheapest surface that is within a tolerance there.
#pragma once

#include "core/chart/chart.h"
#include "core/render/progress.h"
#include "core/study/trade/judge.h"
#include "core/study/trade/recipe.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace reflectance {

struct SufficientModel {
    Recipe recipe;            ///< the scene with its surface simplified by the recipe's rungs
    double nanoseconds = 0.0; ///< per shading in SIMD, caches warm
    std::size_t pixels = 0;   ///< that it suffices for and nothing cheaper does
    ChartColor color = 0;
};

struct SufficientMap {
    static constexpr std::uint8_t background = 0xFF;

    int width = 0, height = 0;
    std::vector<SufficientModel> models; ///< by rising cost; the last is the scene's own surface
    std::vector<std::uint8_t> modelOf;   ///< per pixel, rows from the top: index into `models`, or background
};

/// All in double on the same samples, against the scene's own surface: what differs is the surface alone. Per pixel: the largest
/// channel's linear difference (for Rmse the root mean square of the three), or dE2000 after exposure. Nothing where stopped.
[[nodiscard]] std::optional<SufficientMap> sufficientModels(const Scene& scene, const RenderSettings& settings,
                                                            double tolerance, Metric metric,
                                                            Progress* progress = nullptr);

/// 8-bit sRGB, rows from the top: each pixel in its model's colour, the background dark.
[[nodiscard]] std::vector<std::uint8_t> painted(const SufficientMap& map);

} // namespace reflectance
