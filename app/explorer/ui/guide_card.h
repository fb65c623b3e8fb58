// The tour's card: what a step says, asks and answers, and the way to the next one.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// In the current window, which it fills. Nothing outside the tour.
void drawGuideCard(ExplorerState& state);

/// "1.5" with as many digits as the claim is about.
[[nodiscard]] std::string claimText(const Claim& claim, double value);

} // namespace reflectance::explorer
