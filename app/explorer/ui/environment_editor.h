// What surrounds the object, and what is seen behind it.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawEnvironmentEditor(ExplorerState& state);

/// "none", "constant", "studio", "picture".
[[nodiscard]] const char* nameOf(EnvironmentKind kind);

} // namespace reflectance::explorer
