// Parts of the trade's page: the chart that is pointed at, and what stands beside it.
#pragma once

#include "app/explorer/state.h"

#include <imgui.h>

namespace reflectance::explorer {

/// Takes that much with its heading. A click on a dot selects its candidate, the tolerance line can be dragged.
void drawTradeChart(ExplorerState& state, ImVec2 whole);

/// Figures of one candidate, and what it gives up.
void drawTradeCandidate(const TradeStudy& study);

/// What each term buys and costs, as bars.
void drawTradeTerms(const TradeStudy& study);

/// The colours of the map.
void drawMapLegend(const SufficientMap& map);

} // namespace reflectance::explorer
