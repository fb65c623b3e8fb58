// Starts and gives up the workbench's fits, and takes their results over.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// Call once a frame.
void pollFit(Session& session);

} // namespace reflectance::explorer
