// What both kinds of plots are drawn with. Internal to them.
#pragma once

#include "app/explorer/ui/widgets.h"

#include <string>
#include <vector>

namespace reflectance::explorer {

/// The area of a plot as one item that can be hovered and that Tab reaches.
struct PlotArea {
    ImVec2 topLeft, size;
    bool hovered = false;
};
[[nodiscard]] PlotArea plotArea(const char* id, ImVec2 size);

/// A line of a legend or a reading.
struct PlotEntry {
    ImU32 color = 0;
    std::string text;
};
/// Downwards from the upper right corner, without covering `width` pixels left of it where there is no room.
void drawLegend(ImDrawList& list, ImVec2 upperRight, const std::vector<PlotEntry>& entries);

/// A floating list beside the mouse, headed by where it is.
void showReading(const std::string& heading, const std::vector<PlotEntry>& entries);

/// Moves the entry whose place is nearest to the mouse to the top, and marks all places, that one with a ring.
void markReadings(ImDrawList& list, std::vector<PlotEntry>& entries, std::vector<ImVec2>& places, ImVec2 mouse);

inline constexpr const char* readingHint = "Move the mouse over the curves to read their values.";

enum class TextAnchor { Left, Centre, Right };
/// Small text whose vertical middle is at y.
void plotText(ImDrawList& list, float x, float y, TextAnchor anchor, std::string_view text,
              ImU32 color = palette::quiet);

} // namespace reflectance::explorer
