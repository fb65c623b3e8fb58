// Probed points over the picture: marks in every pane, the card of values, and that a term is seen alone.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// Into the picture's own window, after the picture; examines what has changed first.
void drawProbes(Session& session, const Area& area);

} // namespace reflectance::explorer
