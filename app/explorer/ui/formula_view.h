// Draws a typeset formula at the cursor.
#pragma once

#include "app/explorer/ui/formula.h"

namespace reflectance::explorer {

/// Lines break after commas where the next part would not fit into `width` pixels.
void drawFormula(const std::vector<FormulaPiece>& formula, float width);

} // namespace reflectance::explorer
