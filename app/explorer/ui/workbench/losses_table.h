// Where three digits are lost, as a table: the first exponent, angle or length, for the textbook's formulas and for ours.
#pragma once

#include "core/study/extremes/sweep.h"

#include <span>

namespace reflectance::explorer {

void drawLossesTable(std::span<const SweepRow> rows);

} // namespace reflectance::explorer
