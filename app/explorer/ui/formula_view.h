// Draws a typeset formula at the cursor.
#pragma once

#include "app/explorer/ui/formula.h"

namespace reflectance::explorer {

/// Lines break after commas where the next part would not fit into `width` pixels.
void drawFormula(const std::vector<FormulaPiece>& formula, float width);

/// What of it there is room for on one line of `width` pixels, with an ellipsis where there is more.
[[nodiscard]] std::vector<FormulaPiece> formulaWithin(std::vector<FormulaPiece> formula, float width);

} // namespace reflectance::explorer
