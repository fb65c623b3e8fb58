// Whether GL is within its bound of double on this driver: a badge in the picture's corner, and the worst pixel marked.
#pragma once

#include "app/explorer/state.h"

#include <imgui.h>

namespace reflectance::explorer {

struct Badge {
    std::string text;
    std::string about; ///< tooltip
    ImU32 color;       ///< green within the bound, red beyond, grey while it is not known
};
[[nodiscard]] Badge badgeOf(const ExplorerState& state);

[[nodiscard]] float glBadgeWidth(const ExplorerState& state);

/// In the current window. A click marks the worst pixel, or marks it no more.
void drawGlBadge(ExplorerState& state, ImVec2 topLeft);

/// True where the worst pixel is to be marked: it was asked for, or it is beyond its bound.
[[nodiscard]] bool worstPixelIsMarked(const ExplorerState& state);

/// A ring about the worst pixel, whose middle is at `centre`. A click selects it: its values stand beside it, inside
/// `low` .. `high`; another puts them away.
void drawWorstPixel(ExplorerState& state, ImVec2 centre, ImVec2 low, ImVec2 high);

} // namespace reflectance::explorer
