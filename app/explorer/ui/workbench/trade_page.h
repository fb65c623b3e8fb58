// The workbench's page of the trade: what every cheaper way of drawing this view loses and saves.
#pragma once

namespace reflectance::explorer {

struct ExplorerState;

void drawTradePage(ExplorerState& state);

} // namespace reflectance::explorer
