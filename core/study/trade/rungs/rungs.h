// The changes behind the rungs, a file per axis; for rungs.cpp.
#pragma once

#include "core/study/trade/rung.h"

namespace reflectance::rung {

Applied inPrecision(int precision, Recipe& recipe);
Applied halfBuffer(int amount, Recipe& recipe);

Applied diagonalK(int amount, Recipe& recipe);
Applied colourUnderWhite(int amount, Recipe& recipe);
Applied greyK(int amount, Recipe& recipe);

Applied lobeAs(int form, Recipe& recipe);

Applied generalPath(int amount, Recipe& recipe);

Applied withoutHighlight(int amount, Recipe& recipe);
Applied qualitativeOrenNayar(int amount, Recipe& recipe);
Applied energyPreserving(int polynomial, Recipe& recipe);
Applied smoothMatte(int amount, Recipe& recipe);

Applied shadedAt(int place, Recipe& recipe);
Applied bodyPerVertex(int amount, Recipe& recipe);

Applied samplesPerAxis(int k, Recipe& recipe);
Applied reducedBy(int factor, Recipe& recipe);

Applied asTable(int amount, Recipe& recipe);
Applied thinnedTable(int every, Recipe& recipe);
Applied interpolatedBy(int interpolation, Recipe& recipe);

Applied oneLightColour(int amount, Recipe& recipe);

Applied withoutFaintLights(int share, Recipe& recipe);

Applied oneColourAround(int amount, Recipe& recipe);
Applied nineCoefficients(int amount, Recipe& recipe);
Applied coarseSurroundings(int factor, Recipe& recipe);

} // namespace reflectance::rung
