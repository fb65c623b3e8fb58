// When the picture has been at rest for a while, the price tags of the current scene are measured.
#pragma once

#include "app/explorer/session.h"

namespace reflectance::explorer {

/// The picture's rest before anything is measured.
inline constexpr std::chrono::milliseconds restBeforeMeasuring{500};

/// Call after the picture was drawn: gives measurements up when it changed, starts them when it rests, takes them over.
void pollPrices(Session& session);

/// Seconds until pollPrices has something to start; infinity where it has not.
[[nodiscard]] double secondsUntilPrices(const Session& session);

} // namespace reflectance::explorer
