// Where in the tour the user is. While it lasts the user's scene is put aside, as for a hazard's case.
#pragma once

#include "app/explorer/tour.h"

#include <vector>

namespace reflectance::explorer {

struct ExplorerState;

struct Guide {
    int number = 0; ///< of the step that is shown, from 1; 0 outside the tour
    TourStep step;
    int picked = 0; ///< the choice that was made, from 1; 0 for none yet
    bool revealed = false;
    std::vector<double> values; ///< of the step's claims, measured when the answer is shown
};

/// Shows a step in the place of the user's scene; a number outside the tour is brought into it. A step that cannot be
/// read changes nothing but the message.
void showTourStep(ExplorerState& state, int number);

/// Shows the answer, and measures what it says.
void revealAnswer(Guide& guide);

} // namespace reflectance::explorer
