// Answers what the page of curves wants to show, on another thread. One question at a time runs to its end; what was asked
// meanwhile comes after it, so that a drag is followed and never waits.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// Call once a frame, after the page was drawn.
void pollPlots(Session& session);

} // namespace reflectance::explorer
