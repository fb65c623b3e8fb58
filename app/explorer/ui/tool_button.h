// The buttons of the toolbar: an icon, and a word where there is room.
#pragma once

#include "app/explorer/ui/icons.h"

namespace reflectance::explorer {

struct ToolButton {
    Icon icon;
    const char* label;
    bool on = false;
    bool withLabel = true; ///< false: the icon alone
    bool enabled = true;
};

[[nodiscard]] float toolButtonHeight();
[[nodiscard]] float toolButtonWidth(const char* label, bool withLabel);

/// Draws it and stays on the line. True where it was pressed.
bool drawToolButton(const ToolButton& button, const char* about);

} // namespace reflectance::explorer
