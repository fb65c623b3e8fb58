#include "app/explorer/window_state.h"

#include <backends/imgui_impl_glfw.h>

#include <algorithm>
#include <utility>

namespace reflectance::explorer {
namespace {

std::string namedKey(int key)
{
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return "F" + std::to_string(1 + key - GLFW_KEY_F1);
    switch (key) {
    case GLFW_KEY_PAGE_UP:
        return "PageUp";
    case GLFW_KEY_PAGE_DOWN:
        return "PageDown";
    case GLFW_KEY_ESCAPE:
        return "Esc";
    case GLFW_KEY_LEFT:
        return "Left";
    case GLFW_KEY_RIGHT:
        return "Right";
    case GLFW_KEY_UP:
        return "Up";
    case GLFW_KEY_DOWN:
        return "Down";
    default:
        return {};
    }
}

/// The key's character on the user's layout, else its name.
std::string keyName(int key, int scancode)
{
    std::string named = namedKey(key);
    if (!named.empty())
        return named;
    const char* character = glfwGetKeyName(key, scancode);
    return character ? character : "";
}

/// Dear ImGui 1.86 knows keys by their place on a US keyboard. Its shortcuts in text fields are letters, and the key that carries
/// the letter is meant: Z and Y trade places on a German one.
int keyByLetter(int key, int scancode)
{
    const char* character = namedKey(key).empty() ? glfwGetKeyName(key, scancode) : nullptr;
    const bool letter = character && character[0] >= 'a' && character[0] <= 'z' && character[1] == '\0';
    return letter ? GLFW_KEY_A + (character[0] - 'a') : key;
}

WindowState& stateOf(GLFWwindow* window)
{
    return *static_cast<WindowState*>(glfwGetWindowUserPointer(window));
}

/// Dear ImGui 1.86 looks at keys once a frame: a tap between two frames is told as lasting until the next one.
void tellImGui(GLFWwindow* window, int key, int scancode, int action, int modifiers)
{
    WindowState& state = stateOf(window);
    if (action == GLFW_PRESS)
        state.freshKeys.push_back(key);
    const bool unseen = std::find(state.freshKeys.begin(), state.freshKeys.end(), key) != state.freshKeys.end();
    if (action == GLFW_RELEASE && unseen)
        state.lateReleases.push_back(key);
    else
        ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, modifiers);
}

bool isArrow(int key)
{
    return key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT || key == GLFW_KEY_UP || key == GLFW_KEY_DOWN;
}

/// Arrows belong to the controls once Tab has gone to them, and while something is typed.
bool arrowsAreOurs(const WindowState& state)
{
    return state.arrowsForPicture && !ImGui::GetIO().NavVisible && !ImGui::GetIO().WantTextInput;
}

void keyPressed(GLFWwindow* window, int key, int scancode, int action, int modifiers)
{
    WindowState& state = stateOf(window);
    state.happened = true;
    const bool arrow = isArrow(key);
    if (!arrow || !arrowsAreOurs(state) || action == GLFW_RELEASE)
        tellImGui(window, keyByLetter(key, scancode), scancode, action, modifiers);
    if (arrow && !arrowsAreOurs(state))
        return;
    const bool control = (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0;
    const std::string name = keyName(key, scancode);
    const bool ownUndo = control && (name == "z" || name == "y"); // a text field has its own
    const bool typing = ImGui::GetIO().WantTextInput && (!control || ownUndo) && namedKey(key).empty();
    const bool pressed = action == GLFW_PRESS || (arrow && action == GLFW_REPEAT);
    if (!pressed || typing || (modifiers & GLFW_MOD_ALT) != 0)
        return;
    if (!name.empty())
        state.events.keys.push_back({name, control, (modifiers & GLFW_MOD_SHIFT) != 0});
}

void filesDropped(GLFWwindow* window, int count, const char** paths)
{
    stateOf(window).happened = true;
    stateOf(window).events.dropped.assign(paths, paths + count);
}

void cursorMoved(GLFWwindow* window, double x, double y)
{
    stateOf(window).happened = true;
    stateOf(window).cursor = {static_cast<float>(x), static_cast<float>(y)};
}

void buttonChanged(GLFWwindow* window, int, int action, int)
{
    WindowState& state = stateOf(window);
    state.happened = true;
    if (action == GLFW_RELEASE)
        state.releasedAt = state.cursor;
    else if (!state.pressedAt)
        state.pressedAt = state.cursor;
}

} // namespace

void noteEvents(GLFWwindow* window)
{
    glfwSetDropCallback(window, filesDropped);
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned) { stateOf(w).happened = true; });
    glfwSetCursorPosCallback(window, cursorMoved);
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { stateOf(w).happened = true; });
    glfwSetMouseButtonCallback(window, buttonChanged);
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { stateOf(w).happened = true; });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { stateOf(w).happened = true; });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { stateOf(w).happened = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { stateOf(w).happened = true; });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { stateOf(w).happened = true; });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { stateOf(w).happened = true; });
}

void takeKeys(GLFWwindow* window)
{
    glfwSetKeyCallback(window, keyPressed);
}

void placeMouse(WindowState& state)
{
    if (const auto pressedAt = std::exchange(state.pressedAt, std::nullopt))
        ImGui::GetIO().MousePos = *pressedAt;
    else if (const auto releasedAt = std::exchange(state.releasedAt, std::nullopt))
        ImGui::GetIO().MousePos = *releasedAt;
}

void releaseKeys(WindowState& state)
{
    state.freshKeys.clear();
    for (const int key : std::exchange(state.lateReleases, {}))
        ImGui_ImplGlfw_KeyCallback(state.window, key, 0, GLFW_RELEASE, 0);
}

} // namespace reflectance::explorer
