// The lens' legend and controls, in the picture's corner, and what it reads under the mouse.
#pragma once

#include "app/explorer/state.h"

#include <imgui.h>

namespace reflectance::explorer {

/// Ends at `bottomRight`, in the current window.
void drawLensLegend(ExplorerState& state, ImVec2 bottomRight);

/// "float keeps 3.7 of 7.2 digits", or what the pixel is marked for.
[[nodiscard]] std::string lensSentence(LensKind kind, const LensPixel& pixel);

/// Digits, values and the term responsible, as a tooltip.
void showLensReading(LensKind kind, const LensReading& reading);

} // namespace reflectance::explorer
