// Does what panels, keys and dropped files asked for.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// Serves every request in the state and empties the list.
void serveRequests(Session& session);

/// Starts reading the next waiting file, takes over one that was read, and keeps the progress in the state.
void pollFiles(Session& session);

} // namespace reflectance::explorer
