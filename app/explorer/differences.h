// While A and B are compared, what separates their pictures is measured: RMSE, largest difference and the map as fast as a
// thread can, dE2000 once the picture rests.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// Call after the pictures were drawn: takes results over and starts what is owed.
void pollDifference(Session& session);

/// Seconds until pollDifference has something to start; infinity where it has not.
[[nodiscard]] double secondsUntilDifference(const Session& session);

} // namespace reflectance::explorer
