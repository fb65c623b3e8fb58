// Keeps what is known of the probed points up to date, and draws it over the picture.
#pragma once

#include "app/explorer/state.h"
#include "app/explorer/viewport.h"
#include "core/image/image.h"

#include <memory>
#include <optional>

namespace reflectance::explorer {

struct Session;
struct Rested;

/// What was examined last.
struct Probes {
    std::optional<Scene> viewed;
    ViewSize size;
    bool comparing = false, lobe = false;
    std::size_t light = 0;
    std::uint64_t changes = 0;
    std::shared_ptr<const Rested> rested; ///< whose pixels were read
    Image b;                              ///< B's picture at that rest
};

/// What the key P asked for: the point under the mouse, or in the middle of the picture where the mouse is not on it, on the page
/// of probes. Before the page may change the picture's size.
void serveProbeKey(Session& session);

/// Examines what has changed. After the picture is drawn.
void pollProbes(Session& session);

} // namespace reflectance::explorer
