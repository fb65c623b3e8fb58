// What the picture shows of the scene.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// The scene as it is drawn (shownScene), with one of its terms alone where that is wished for. A term that the scene lacks by
/// now is not asked for. The scene itself stays as it is: this is how it is looked at.
[[nodiscard]] Scene viewedScene(const ExplorerState& state);

/// Whether one of its terms is seen alone, and in what words.
[[nodiscard]] bool seesTermAlone(const ExplorerState& state);
[[nodiscard]] std::string wordsFor(const std::string& term); ///< "diffuse term", "off-diagonal K"

/// Probes the point under a place in the picture: a pin that lies there, else a new one. Beside the object what was probed last is
/// put away.
void probeUnder(ExplorerState& state, Cursor cursor, ViewSize size);

/// Brings what is known of the probed places up to date for the viewed scene; `picture` is its size.
void examine(ExplorerState& state, const Scene& viewed, ViewSize picture);

} // namespace reflectance::explorer
