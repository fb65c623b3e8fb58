// Models as lobes in space and as maps over both angles.
#pragma once

#include "core/chart/heat_map.h"
#include "core/chart/lobe_chart.h"
#include "core/render/progress.h"
#include "core/study/curves.h"
#include "core/study/tables/table_maps.h"

#include <optional>
#include <vector>

namespace reflectance {

/// Directions 4 by 7.5 degrees apart, closer about the mirrored one. Nothing where `progress` was cancelled.
[[nodiscard]] std::optional<LobeChart> lobesOf(const std::vector<NamedSurface>& surfaces, const CurveSettings& settings,
                                               const Progress& progress);

/// One surface over theta_r and theta_i (not that of the settings), in double. Nothing where `progress` was cancelled.
[[nodiscard]] std::optional<HeatMap> modelMap(const NamedSurface& surface, const CurveSettings& settings,
                                              double deltaPhi, const Progress& progress);

} // namespace reflectance
