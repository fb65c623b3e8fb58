// The controls of the selected light.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// Nothing where no light is selected.
void drawLightEditor(ExplorerState& state);

/// "Perfect mirror": the models of the catalogue for which `uses` holds, for remarks on what looks at what.
[[nodiscard]] std::string modelsThat(bool ModelText::*uses);

} // namespace reflectance::explorer
