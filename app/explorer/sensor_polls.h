// Starts what the pages of sensor and colour ask for of the picture at rest, and takes it over.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// The pixel under the mouse, the waterfall while its page is open, and the price of the cheats on the object. Once a frame.
void pollSensorStudy(Session& session);

} // namespace reflectance::explorer
