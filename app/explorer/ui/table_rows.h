// The measured table of a surface: its file, and what is known about it.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void tableRows(ExplorerState& state);

/// The button alone that asks for a measurement.
void tableChooser(ExplorerState& state);

} // namespace reflectance::explorer
