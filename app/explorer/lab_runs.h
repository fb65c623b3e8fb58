// Starts and stops the workbench's goniometer, and shows how far it is.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// Call once a frame.
void pollLab(Session& session);

} // namespace reflectance::explorer
