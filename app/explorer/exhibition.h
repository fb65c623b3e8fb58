// A hazard's case or a step of the tour in the place of the user's scene, which waits untouched until it comes back.
#pragma once

#include "app/explorer/comparison.h"
#include "core/scene/same_scene.h"
#include "core/study/extremes/extremes.h"

#include <string>

namespace reflectance::explorer {

struct ExplorerState;

/// The user's scene and what belongs to looking at it, while a case is shown.
struct PutAside {
    Scene scene;
    int selectedLight = 0, soloLight = -1;
    bool turntable = false;
    bool comparing = false;
    CompareMode mode = CompareMode::SideBySide;
    std::string title, caption; ///< of the case that is shown

    friend bool operator==(const PutAside&, const PutAside&) = default;
};

/// Puts the user's scene aside, unless it is already, and says what stands in its place. The scene on screen stays for now.
void putAside(ExplorerState& state, std::string title, std::string caption);

/// Shows the finding's case. One that cannot be shown changes nothing but the message, which says why.
void showCase(ExplorerState& state, const Finding& finding);

/// The user's scene again, exactly as it was. False where it is there already.
bool leaveCase(ExplorerState& state);

/// What the user works on, whatever is shown: this is kept against crashes.
[[nodiscard]] const Scene& usersScene(const ExplorerState& state);

} // namespace reflectance::explorer
