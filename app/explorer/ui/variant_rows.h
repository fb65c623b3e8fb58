// The variants that a scene keeps under names: a list from which A and B are chosen.
#pragma once

#include "app/explorer/state.h"

#include <cstddef>

namespace reflectance::explorer {

/// Part of the Surface card. Keeping, renaming, renewing and removing change the list; choosing copies a variant to A or B.
void variantRows(ExplorerState& state);

/// The variant becomes A.
void showAsA(ExplorerState& state, std::size_t variant);
/// The variant becomes B, which is then compared.
void showAsB(ExplorerState& state, std::size_t variant);

} // namespace reflectance::explorer
