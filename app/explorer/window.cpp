#include "app/explorer/window.h"

#include "app/explorer/ui/ui.h"

#define GLFW_INCLUDE_GLCOREARB
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace reflectance::explorer {
namespace {

std::string lastGlfwError;

std::string namedKey(int key)
{
    switch (key) {
    case GLFW_KEY_ESCAPE: return "Esc";
    case GLFW_KEY_F1: return "F1";
    case GLFW_KEY_F12: return "F12";
    default: return {};
    }
}

/// The key's character on the user's layout, else its name.
std::string keyName(int key, int scancode)
{
    const std::string named = namedKey(key);
    if (!named.empty())
        return named;
    const char* character = glfwGetKeyName(key, scancode);
    return character ? character : "";
}

float monitorScale(GLFWwindow* window)
{
    float x = 1.0F, y = 1.0F;
    glfwGetWindowContentScale(window, &x, &y);
    return std::max({x, y, 0.5F});
}

void setHints()
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE); // macOS gives core contexts only so
    glfwWindowHint(GLFW_DEPTH_BITS, 0);                    // the renderer draws into its own buffers
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE); // shown with its first frame
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "Reflectance");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "reflectance");
#ifdef REFLECTANCE_DEBUG_CONTEXT
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
#endif
}

} // namespace

std::optional<Desktop> Desktop::connect()
{
    glfwSetErrorCallback([](int, const char* text) { lastGlfwError = text; });
    if (glfwInit() != GLFW_TRUE)
        return std::nullopt;
    return Desktop();
}

Desktop::Desktop(Desktop&& other) noexcept : owned_(std::exchange(other.owned_, false)) {}

Desktop::~Desktop()
{
    if (owned_)
        glfwTerminate();
}

struct WindowState {
    GLFWwindow* window = nullptr;
    ImGuiContext* gui = nullptr;
    Events events;
    std::string title;
    ImVec2 cursor;                    ///< as of the last event: glfwGetCursorPos asks for the present, which is later
    std::optional<ImVec2> pressedAt;  ///< the first press of a mouse button that no frame has seen
    std::optional<ImVec2> releasedAt; ///< the last release that no frame has seen
    bool happened = false;
    bool shown = false;
    float chosenScale = 0.0F; ///< 0: the monitor's
    float fontScale = 0.0F;   ///< the scale that the fonts were made for

    WindowState() = default;
    WindowState(const WindowState&) = delete;
    WindowState& operator=(const WindowState&) = delete;
    ~WindowState()
    {
        if (gui) {
            ImGui_ImplOpenGL3_Shutdown();
            ImGui_ImplGlfw_Shutdown();
            ImGui::DestroyContext(gui);
        }
        if (window)
            glfwDestroyWindow(window);
    }
};

namespace {

std::atomic<bool> woken{false};

WindowState& stateOf(GLFWwindow* window)
{
    return *static_cast<WindowState*>(glfwGetWindowUserPointer(window));
}

void keyPressed(GLFWwindow* window, int key, int scancode, int action, int modifiers)
{
    stateOf(window).happened = true;
    const bool control = (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0;
    const bool typing = ImGui::GetIO().WantTextInput && !control && namedKey(key).empty();
    if (action != GLFW_PRESS || typing || (modifiers & GLFW_MOD_ALT) != 0)
        return;
    if (std::string name = keyName(key, scancode); !name.empty())
        stateOf(window).events.keys.push_back({std::move(name), control, (modifiers & GLFW_MOD_SHIFT) != 0});
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

/// A press and a release count where they happened, even if the hand has moved on before the frame that sees them.
void placeMouse(WindowState& state)
{
    if (const auto pressedAt = std::exchange(state.pressedAt, std::nullopt))
        ImGui::GetIO().MousePos = *pressedAt;
    else if (const auto releasedAt = std::exchange(state.releasedAt, std::nullopt))
        ImGui::GetIO().MousePos = *releasedAt;
}

/// Notes that something happened; ImGui's back end calls these and then does its own part.
void installCallbacks(GLFWwindow* window)
{
    glfwSetKeyCallback(window, keyPressed);
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

/// Fonts are made for the monitor's pixels and shown in points.
void renewFonts(WindowState& state, float scale, float pixelsPerPoint)
{
    const float wanted = scale * pixelsPerPoint;
    if (wanted == state.fontScale)
        return;
    state.fontScale = wanted;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui::GetIO().Fonts->Clear();
    loadFonts(wanted);
    ImGui::GetIO().FontGlobalScale = 1.0F / pixelsPerPoint;
    applyTheme(scale);
}

} // namespace

Window::Window(std::unique_ptr<WindowState> state) : state_(std::move(state)) {}
Window::Window(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::open(int width, int height, float scale)
{
    auto state = std::make_unique<WindowState>();
    setHints();
    state->chosenScale = scale;
    state->window = glfwCreateWindow(width, height, "Reflectance Explorer", nullptr, nullptr);
    if (!state->window)
        return Error{"no window with OpenGL 3.3 could be opened (" + lastGlfwError +
                     "); 'reflectance render' needs none and draws to a file"};
    glfwSetWindowSizeLimits(state->window, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(state->window, state.get());
    glfwMakeContextCurrent(state->window);
    glfwSwapInterval(1);
    installCallbacks(state->window);

    state->gui = ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // the preferences hold what is kept
    ImGui_ImplGlfw_InitForOpenGL(state->window, true);
    if (!ImGui_ImplOpenGL3_Init("#version 330 core"))
        return Error{"the interface could not be drawn with this OpenGL driver; try LIBGL_ALWAYS_SOFTWARE=1"};
    return Window(std::move(state));
}

bool Window::wait(double seconds)
{
    if (seconds <= 0.0)
        glfwPollEvents();
    else if (std::isinf(seconds))
        glfwWaitEvents();
    else
        glfwWaitEventsTimeout(seconds);
    const bool wokenUp = woken.exchange(false);
    return std::exchange(state_->happened, false) || wokenUp;
}

Events Window::takeEvents()
{
    return std::exchange(state_->events, {});
}

bool Window::closing() const
{
    return glfwWindowShouldClose(state_->window) == GLFW_TRUE;
}

void Window::setTitle(const std::string& title)
{
    if (std::exchange(state_->title, title) != title) // the window manager answers with an event, which would be a frame
        glfwSetWindowTitle(state_->window, title.c_str());
}

void Window::beginFrame()
{
    renewFonts(*state_, scale(), pixelsPerPoint());
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    placeMouse(*state_);
    ImGui::NewFrame();
}

void Window::drawFrame()
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::showFrame()
{
    glfwSwapBuffers(state_->window);
    if (!std::exchange(state_->shown, true))
        glfwShowWindow(state_->window);
}

ViewSize Window::size() const
{
    ViewSize size;
    glfwGetWindowSize(state_->window, &size.width, &size.height);
    return size;
}

ViewSize Window::framebuffer() const
{
    ViewSize size;
    glfwGetFramebufferSize(state_->window, &size.width, &size.height);
    return size;
}

float Window::pixelsPerPoint() const
{
    const ViewSize points = size();
    return points.width > 0 ? static_cast<float>(framebuffer().width) / static_cast<float>(points.width) : 1.0F;
}

float Window::scale() const
{
    const float pixels = state_->chosenScale > 0.0F ? state_->chosenScale : monitorScale(state_->window);
    return std::max(0.5F, pixels / pixelsPerPoint());
}

GetProcAddress Window::loader()
{
    return glfwGetProcAddress;
}

void Window::wake()
{
    woken = true;
    glfwPostEmptyEvent();
}

} // namespace reflectance::explorer
