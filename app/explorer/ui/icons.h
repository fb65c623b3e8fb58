// The toolbar's icons, drawn with lines so that they are sharp at every scale.
#pragma once

#include <imgui.h>

namespace reflectance::explorer {

enum class Icon { Open, Undo, Redo, Frame, Turntable, Lights, Compare, Camera, Lens, Grab, Reset, Tour, Help };

/// Inside the circle of `radius` about `centre`.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 centre, float radius, ImU32 color);

} // namespace reflectance::explorer
