// The controls of lists: the choice that says how many numbers count, and the numbers under their names.
#pragma once

#include "app/explorer/state.h"
#include "core/reflectance/model_text.h"

namespace reflectance::explorer {

/// A button per choice. Lists that follow it are kept in step: numbers of the same name stay, new ones start at 0.
void choiceRows(const ModelText& model, const Parameter& choice, ExplorerState& state);

/// A fold with a row for each number that counts.
void listRows(const ModelText& model, const Parameter& list, ExplorerState& state);

} // namespace reflectance::explorer
