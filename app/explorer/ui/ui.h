// The explorer's look and panels, as the window calls them. Every function draws with Dear ImGui into the current
// window and changes nothing but the state; what needs GL, files or the desktop is left as a request in the state.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// Puts the embedded faces into ImGui's atlas. Call once after ImGui::CreateContext and again when the scale changes
/// (then the backend's font texture must be made anew). `scale` is 1 for a 96 dpi monitor.
void loadFonts(float scale);

/// Colours, spacing and rounding; turns keyboard navigation on.
void applyTheme(float scale);

/// The three stages in the lecture's order - illumination, surface, sensor - one below the other in the current window.
/// The window scrolls; give it the width of Preferences::panelWidth.
void drawPanels(ExplorerState& state);

/// One row of buttons; give it the window's width and toolbarHeight() pixels.
void drawToolbar(ExplorerState& state);
[[nodiscard]] float toolbarHeight();

/// One row of figures; give it the window's width and statusLineHeight() pixels. Messages float above it.
void drawStatusLine(ExplorerState& state);
[[nodiscard]] float statusLineHeight();

/// The strip of tabs below the picture: a click opens a page of the workbench, a click on the open one closes it.
void drawWorkbenchTabs(ExplorerState& state);
[[nodiscard]] float workbenchTabsHeight();

/// The open page of the workbench in the current window; nothing while it is closed.
void drawWorkbench(ExplorerState& state);

/// True while a page is open; a page that this program does not know counts as none.
[[nodiscard]] bool workbenchIsOpen(const ExplorerState& state);

/// The table of gestures and keys over everything else, while state.showHelp.
void drawHelp(ExplorerState& state);

/// The file browser over everything else, while state.showFileBrowser; a chosen file becomes an OpenFile request.
void drawFileBrowser(ExplorerState& state);

} // namespace reflectance::explorer
