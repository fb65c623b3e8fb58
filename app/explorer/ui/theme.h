// The palette: neutral greys, so that the eye judges the colours of the picture and not those of the frame, and one
// accent. Text on every ground it is used on has a contrast of at least 4.5 : 1.
#pragma once

#include <imgui.h>

namespace reflectance::explorer::palette {

inline constexpr ImU32 ground = IM_COL32(27, 27, 27, 255);   ///< behind the cards
inline constexpr ImU32 card = IM_COL32(36, 36, 36, 255);     ///< a stage
inline constexpr ImU32 well = IM_COL32(22, 22, 22, 255);     ///< where a value sits
inline constexpr ImU32 raised = IM_COL32(54, 54, 54, 255);   ///< buttons
inline constexpr ImU32 floating = IM_COL32(46, 46, 46, 255); ///< menus, tooltips, messages
inline constexpr ImU32 hovered = IM_COL32(68, 68, 68, 255);  ///< what the mouse is on
inline constexpr ImU32 line = IM_COL32(58, 58, 58, 255);     ///< borders and separators
inline constexpr ImU32 text = IM_COL32(228, 228, 228, 255);
inline constexpr ImU32 quiet = IM_COL32(170, 170, 170, 255);  ///< remarks, units, ranges
inline constexpr ImU32 faint = IM_COL32(104, 104, 104, 255);  ///< what cannot be used now
inline constexpr ImU32 accent = IM_COL32(112, 172, 232, 255); ///< symbols, marks, what can be acted on
inline constexpr ImU32 fill = IM_COL32(40, 62, 86, 255);      ///< the filled part of a slider
inline constexpr ImU32 chosen = IM_COL32(50, 80, 112, 255);   ///< what is selected or switched on
inline constexpr ImU32 warning = IM_COL32(232, 178, 92, 255);
inline constexpr ImU32 error = IM_COL32(242, 128, 118, 255);
inline constexpr ImU32 good = IM_COL32(134, 196, 136, 255);

} // namespace reflectance::explorer::palette
