// The software driver is a hundred megabytes of code: it can be opened while something else is done.
#pragma once

#include "core/render/headless/headless_context.h"

#include <thread>

namespace reflectance {

/// Opens the libraries that openHeadless(kind) would try first, on a thread of its own. Whether they are there is for
/// openHeadless to say.
[[nodiscard]] std::jthread openDriverAhead(ContextKind kind);

} // namespace reflectance
