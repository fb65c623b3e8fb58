// The controls of one model parameter, made from its declaration in the model's text.
#pragma once

#include "app/explorer/ui/number_row.h"
#include "core/reflectance/model_text.h"

namespace reflectance::explorer {

/// The slider of the parameter's i-th number.
[[nodiscard]] NumberRow rowOf(const Parameter& parameter, std::size_t i);

/// Number, colour, matrix, choice or list; changed values go to the surface in hand.
void parameterRows(const ModelText& model, const Parameter& parameter, ExplorerState& state);

} // namespace reflectance::explorer
