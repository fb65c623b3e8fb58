// What a window keeps, and the news that GLFW brings to it. Only window.cpp and window_input.cpp look in here.
#pragma once

#include "app/explorer/window.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

struct WindowState {
    GLFWwindow* window = nullptr;
    ImGuiContext* gui = nullptr;
    Events events;
    std::string title;
    ImVec2 cursor;                    ///< as of the last event: glfwGetCursorPos asks for the present, which is later
    std::optional<ImVec2> pressedAt;  ///< the first press of a mouse button that no frame has seen
    std::optional<ImVec2> releasedAt; ///< the last release that no frame has seen
    std::vector<int> freshKeys;       ///< pressed since the last frame
    std::vector<int> lateReleases;    ///< released before a frame saw the press
    bool happened = false;
    bool arrowsForPicture = false; ///< arrow keys are ours, as long as none of Dear ImGui's controls has the keyboard
    bool shown = false;
    float chosenScale = 0.0F;           ///< 0: the monitor's
    float fontScale = 0.0F;             ///< the scale that the fonts were made for
    float shownScale = 0.0F;            ///< the scale that the theme was made for; 0 before the first frame
    std::unique_ptr<ImFontAtlas> fonts; ///< the context's

    WindowState() = default;
    WindowState(const WindowState&) = delete;
    WindowState& operator=(const WindowState&) = delete;
    ~WindowState();
};

/// Notes what happens in the window. Before Dear ImGui's back end is set up: it calls these and then does its own part.
void noteEvents(GLFWwindow* window);

/// Takes the keys in place of the back end, and passes them on to it. After the back end is set up.
void takeKeys(GLFWwindow* window);

/// A press and a release count where they happened, even if the hand has moved on before the frame that sees them.
/// Before ImGui::NewFrame.
void placeMouse(WindowState& state);

/// Tells Dear ImGui of keys that were released before a frame had seen them pressed. After ImGui::Render.
void releaseKeys(WindowState& state);

} // namespace reflectance::explorer
