// Dear ImGui without a window: frames are laid out and thrown away, the mouse and the keys are set by hand.
#pragma once

#include <functional>
#include <imgui.h>
#include <string>

namespace reflectance::explorer {

class Stage {
public:
    explicit Stage(float width = 1280.0F, float height = 800.0F, float scale = 1.0F);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    using Draw = std::function<void()>;

    /// One frame, a twentieth of a second after the last.
    void frame(const Draw& draw);
    /// The same inside a window at `place` that fills `size`.
    void frameIn(ImVec2 place, ImVec2 size, const Draw& draw);

    void moveTo(ImVec2 point);
    void hold(bool down) { ImGui::GetIO().MouseDown[0] = down; }
    /// Frames: press, release. `draw` is the whole frame.
    void click(ImVec2 point, const Draw& draw);
    void doubleClick(ImVec2 point, const Draw& draw);
    void press(ImGuiKey_ key, const Draw& draw);
    void type(const std::string& text, const Draw& draw);

    [[nodiscard]] static ImGuiID hovered();   ///< the control under the mouse, 0 for none
    [[nodiscard]] static bool showsTooltip(); ///< in the last frame
};

} // namespace reflectance::explorer
