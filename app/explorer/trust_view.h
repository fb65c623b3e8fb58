// What lies over the picture: GL's badge, the worst pixel's mark, the lens' legend and reading, and that a term is
// seen alone.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// Into the picture's own window, after the picture.
void drawTrust(Session& session, const Area& area);

} // namespace reflectance::explorer
