// A page of the workbench: one way of studying the scene, below the picture. A page is a file in this folder and a line
// in pages.cpp. It draws into the current ImGui window, changes nothing but the state, and asks for slow work by setting
// a request or a wish in the state; it never waits.
#pragma once

#include "app/explorer/state.h"

#include <span>

namespace reflectance::explorer {

struct WorkbenchPage {
    const char* id;    ///< kept in the preferences
    const char* name;  ///< on its tab, one word
    const char* about; ///< one sentence, as a tooltip
    void (*draw)(ExplorerState& state);
};

/// In the order of their tabs.
[[nodiscard]] std::span<const WorkbenchPage> workbenchPages();

/// The open page; null while the workbench is closed, and for an id that this program does not know.
[[nodiscard]] const WorkbenchPage* openPage(const ExplorerState& state);

/// Opens the page with this id; closes the workbench if it is open already.
void togglePage(ExplorerState& state, const char* id);

/// Opens the n-th page (from 0), or closes it if it is open; nothing beyond the last.
void togglePage(ExplorerState& state, int index);

} // namespace reflectance::explorer
