// The desktop program: one window in which a reflectance model is looked at, changed and measured.
#pragma once

#include "core/base/result.h"

#include <optional>
#include <string>

namespace reflectance::explorer {

struct ExplorerOptions {
    std::string input;         ///< mesh, scene (.json) or stock mesh ("mug"); empty opens the default scene
    std::string modelFile;     ///< own model (.glsl); empty: none
    std::string record;        ///< file that takes what happens; empty: nothing is recorded
    std::string replay;        ///< recording to begin with; empty for none
    int tour = 0;              ///< the step of the tour to begin with, from 1; 0 for none
    bool firstPicture = false; ///< say what the first picture took, and close the window
    std::optional<std::string> environment; ///< latitude-longitude picture (.exr, .hdr) around the object
};

enum class Outcome {
    Closed,   ///< the user closed the window
    NoDisplay ///< there is no display to open a window on; nothing was done
};

/// Opens the window and returns when it is closed. The Error says why a window could not be had although there is a
/// display (no OpenGL 3.3, say). An input that cannot be read is said in the window, over the default scene.
[[nodiscard]] Result<Outcome> runExplorer(const ExplorerOptions& options);

} // namespace reflectance::explorer
