// Edits a colour matrix K as one number, as a diagonal or in full.
#pragma once

#include "app/explorer/state.h"
#include "core/reflectance/parameter.h"

#include <vector>

namespace reflectance::explorer {

/// `values` are the parameter's nine numbers, row by row. True where they changed.
bool matrixEditor(const Parameter& parameter, std::vector<double>& values, ExplorerState& state);

} // namespace reflectance::explorer
