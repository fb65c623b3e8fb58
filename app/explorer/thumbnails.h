// Makes the pictures that the surfaces' page waits for, a few at a time on another thread, and makes them anew when the
// lights change.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// Call once a frame, after the page was drawn.
void pollThumbnails(Session& session);

} // namespace reflectance::explorer
