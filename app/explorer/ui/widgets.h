// Small pieces that every panel is made of: remarks, tooltips, symbols with subscripts, toggles.
#pragma once

#include "app/explorer/ui/fonts.h"
#include "app/explorer/ui/theme.h"

#include <span>
#include <string>
#include <string_view>

namespace reflectance::explorer {

/// A tooltip for the last item, after the mouse has rested on it; also for disabled items. Wraps.
void tooltip(std::string_view text);

/// True once the mouse has rested on the last item long enough for a tooltip.
[[nodiscard]] bool tooltipIsDue();

/// A tooltip for the current window's own scroll bar.
void scrollBarTooltip(std::string_view text);

/// What goes between is the tooltip; it wraps at a comfortable width.
void beginTooltip();
void endTooltip();

/// True while something changes with time alone: a tooltip about to show, the cursor of a text field.
[[nodiscard]] bool waitsForTime();

/// Text in one face and colour, wrapped at the width that is left.
void remark(std::string_view text, ImU32 color = palette::quiet, Face which = Face::Small);

/// "k_s": an italic letter with its subscript, lowered and smaller. Greek may be written as such. Returns its width.
float symbolWidth(std::string_view symbol);
void drawSymbol(ImDrawList& list, ImVec2 baselineLeft, std::string_view symbol, ImU32 color);

/// A row's left part: symbol and label. The cursor then stands where the control begins, the item width is set to fill.
void rowLabel(std::string_view symbol, std::string_view label, ImU32 color = palette::text);

/// Button that is drawn pressed while `on`.
bool toggleButton(const char* label, bool on, ImVec2 size = {});

/// One of a row of buttons of which one is chosen.
struct Choice {
    const char* label;
    const char* about;
};

/// The row fills the width that is left, shared out by the labels' lengths. Returns the index that was pressed, or -1.
int choiceRow(std::span<const Choice> choices, int current);

/// A menu that drops down from a field; while it returns true, draw the entries and end with ImGui::EndCombo().
[[nodiscard]] bool beginMenu(const char* id, const char* shown);

/// Text shortened with an ellipsis to at most `width` pixels of the current face; whole where it fits.
[[nodiscard]] std::string elided(std::string_view text, float width);

/// A quiet line that opens and closes what follows; returns whether it is open.
[[nodiscard]] bool fold(const char* label, const char* about);

/// Text width in a face.
[[nodiscard]] ImVec2 sizeIn(Face which, std::string_view text);
void drawText(ImDrawList& list, Face which, ImVec2 topLeft, ImU32 color, std::string_view text);

} // namespace reflectance::explorer
