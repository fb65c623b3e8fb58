// Moves the mouse over a grid of points and notes what is under it: two controls with one identity, and controls
// without a tooltip, are faults that no single picture shows.
#pragma once

#include "tests/app/ui/stage.h"

#include <vector>

namespace reflectance::explorer {

struct Faults {
    std::vector<ImVec2> shared; ///< points where a control begins that has the identity of another one
    std::vector<ImVec2> silent; ///< points on controls that show no tooltip
    std::size_t controls = 0;   ///< different identities that were met
};

/// Over the rectangle from `from` to `to`. A control narrower than a step may be missed.
[[nodiscard]] Faults sweep(Stage& stage, ImVec2 from, ImVec2 to, ImVec2 step, const Stage::Draw& draw);

} // namespace reflectance::explorer
