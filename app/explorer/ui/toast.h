// A small window that floats over the picture's lower left corner, with a coloured mark at its edge.
#pragma once

#include <imgui.h>

namespace reflectance::explorer {

/// Stands on `bottomLeft`. What goes between is `width` pixels wide, or as wide as it wants for 0.
void beginToast(const char* id, ImVec2 bottomLeft, float width = 0.0F);

/// Returns the toast's upper edge in pixels, on which another one can stand.
float endToast(ImU32 mark);

} // namespace reflectance::explorer
