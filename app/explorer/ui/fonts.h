// The faces of the interface. Sizes follow the interface's scale, so every length in the panels is given in points.
#pragma once

#include <imgui.h>

namespace reflectance::explorer {

enum class Face {
    Body,        ///< running text and values
    Strong,      ///< headings
    Small,       ///< remarks, upright superscripts
    Italic,      ///< symbols of formulas
    ItalicSmall, ///< their subscripts and superscripts
};

/// The face at the scale that loadFonts was given.
[[nodiscard]] ImFont* face(Face which);

/// Puts the embedded faces into an atlas and draws their glyphs: on any thread, while no ImGui context is
/// there or none of its frames runs. `scale` is 1 for a 96 dpi monitor.
void loadFonts(ImFontAtlas& atlas, float scale);

/// Pixels of a length in points: 1 point is 1 pixel at scale 1.
[[nodiscard]] float points(float length);

} // namespace reflectance::explorer
