// Every gesture and key of the explorer, in the order of the help page. The help overlay and the tooltips print it; the
// window binds the keys.
#pragma once

#include <span>

namespace reflectance::explorer {

struct Shortcut {
    const char* group;   ///< "View", "Lights", "Values", "Plots", "Compare", "Program"
    const char* gesture; ///< "Ctrl+Shift+drag"
    const char* effect;  ///< one short sentence
};

inline constexpr Shortcut shortcutTable[] = {
    {"View", "drag", "orbit about the object"},
    {"View", "middle drag, Shift+drag", "pan"},
    {"View", "wheel, right drag", "zoom"},
    {"View", "F", "frame the object"},
    {"View", "R", "the first view again"},
    {"View", "T", "turntable on or off"},
    {"View", "L, Shift+L", "the lens: digits that float keeps; the next arithmetic"},
    {"View", "click the object, P", "probe that point: the formula with its numbers; P opens the page"},
    {"View", "click a pin", "look at that probe again"},
    {"Lights", "drag a handle", "move that light over the sphere of directions"},
    {"Lights", "click a handle, 1 \u2026 9", "select a light"},
    {"Lights", "Ctrl+Shift+drag", "turn the selected light, anywhere in the view"},
    {"Lights", "Ctrl+Shift+right drag", "distance of a point light, intensity of a directional one"},
    {"Lights", "H", "show or hide the handles"},
    {"Lights", "S", "the tool Grab: drag a highlight, its edge (n, alpha) or the terminator"},
    {"Lights", "arrow keys, with Ctrl", "with Grab: move the highlight by 8 pixels, by 1"},
    {"Lights", "Shift+Up, Shift+Down", "with Grab: a narrower or wider highlight"},
    {"Values", "drag a slider", "change a value"},
    {"Values", "Ctrl+click a slider", "type a value, also beyond the slider where it is legal"},
    {"Values", "double-click a slider", "back to the default"},
    {"Values", "M, Shift+M", "next or previous model; values stay"},
    {"Values", "Tab, arrow keys, Space", "reach and change controls without the mouse"},
    {"Values", "Ctrl+Z, Ctrl+Shift+Z, Ctrl+Y", "undo, redo; the arrow beside them lists every step"},
    {"Plots", "move over a plot", "read its values; Save in its corner writes SVG, PNG or CSV"},
    {"Plots", "drag a lobe", "turn the lobes of the page Curves"},
    {"Compare", "C", "two surfaces A and B, or one again"},
    {"Compare", "X", "the hand from A to B and back; flips the picture in Flip"},
    {"Compare", "Ctrl+drag, Ctrl+click", "take the figures in a rectangle, over the whole object again"},
    {"Compare", "B", "clay, Lambert beside Oren-Nayar; once more brings back what was there"},
    {"Program", "Ctrl+O, or drop a file",
     "open a mesh, a scene, a saved picture, an environment or a model of your own"},
    {"Program", "Ctrl+S", "save the scene"},
    {"Program", "Ctrl+R", "restore the session before a crash, while it is offered"},
    {"Program", "F12, Ctrl+F12", "save a picture of the view, of the whole window"},
    {"Program", "F2 \u2026 F11", "open or close a page of the workbench"},
    {"Program", "G, Page up, Page down", "the guided tour; its steps"},
    {"Program", "F1", "this page"},
    {"Program", "Esc", "close what is on top, stop loading, put a probe away, leave a hazard's case or the tour"},
    {"Program", "Ctrl+Q", "quit"},
};

[[nodiscard]] constexpr std::span<const Shortcut> shortcuts()
{
    return shortcutTable;
}

} // namespace reflectance::explorer
