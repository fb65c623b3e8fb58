// A piece of interface that lies over the picture.
#pragma once

#include <imgui.h>

namespace reflectance::explorer {

inline constexpr ImGuiWindowFlags stillWindow = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;

/// In the current window; end it with ImGui::EndChild().
void beginPiece(const char* id, ImVec2 corner, ImVec2 size);

/// What the padding of a piece takes of its size.
[[nodiscard]] ImVec2 piecePadding();

} // namespace reflectance::explorer
