// Probed points over the picture: marks in every pane, and the card of values.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// Into the picture's own window, after the picture; examines what has changed first.
void drawProbes(Session& session, const Area& area);

} // namespace reflectance::explorer
