// What each key does. Keys arrive by the character they carry on the user's own layout, so that a shortcut's letter is
// where the keyboard says it is.
#pragma once

#include "app/explorer/state.h"

#include <string>

namespace reflectance::explorer {

struct KeyPress {
    std::string key; ///< "f", "1", "F12", "Esc", "Space", "Delete": lower case where it is a character
    bool control = false;
    bool shift = false;
};

/// Changes the state, or leaves a request in it. Keys without a meaning are ignored.
void press(const KeyPress& key, ExplorerState& state);

} // namespace reflectance::explorer
