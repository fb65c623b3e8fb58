#include "app/explorer/window.h"

#include "app/explorer/ui/fonts.h"
#include "app/explorer/ui/ui.h"
#include "app/explorer/window_state.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <utility>

namespace reflectance::explorer {
namespace {

std::string lastGlfwError;
std::atomic<bool> woken{false};

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

/// Fonts are made for the monitor's pixels and shown in points.
void renewFonts(WindowState& state, float scale, float pixelsPerPoint)
{
    const float wanted = scale * pixelsPerPoint;
    if (wanted == state.shownScale)
        return;
    state.shownScale = wanted;
    if (wanted != state.fontScale) {
        state.fontScale = wanted;
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui::GetIO().Fonts->Clear();
        loadFonts(wanted);
    }
    ImGui::GetIO().FontGlobalScale = 1.0F / pixelsPerPoint;
    applyTheme(scale);
}

/// Of the monitor on which the window will most likely open.
float likelyScale()
{
    float x = 1.0F, y = 1.0F;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor())
        glfwGetMonitorContentScale(monitor, &x, &y);
    return std::max({x, y, 0.5F});
}

std::unique_ptr<ImFontAtlas> fontsFor(float scale)
{
    auto atlas = std::make_unique<ImFontAtlas>();
    loadFonts(*atlas, scale);
    return atlas;
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

WindowState::~WindowState()
{
    if (gui) {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext(gui);
    }
    if (window)
        glfwDestroyWindow(window);
}

Window::Window(std::unique_ptr<WindowState> state) : state_(std::move(state)) {}
Window::Window(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::open(int width, int height, float scale)
{
    auto state = std::make_unique<WindowState>();
    setHints();
    state->chosenScale = scale;
    // Glyphs are drawn while the driver makes the window and its context: neither waits for the other.
    state->fontScale = scale > 0.0F ? scale : likelyScale();
    auto fonts = std::async(std::launch::async, fontsFor, state->fontScale);
    state->window = glfwCreateWindow(width, height, "Reflectance Explorer", nullptr, nullptr);
    if (!state->window)
        return Error{"no window with OpenGL 3.3 could be opened (" + lastGlfwError +
                     "); 'reflectance render' needs none and draws to a file"};
    glfwSetWindowSizeLimits(state->window, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(state->window, state.get());
    glfwMakeContextCurrent(state->window);
    glfwSwapInterval(1);
    noteEvents(state->window);

    state->fonts = fonts.get();
    state->gui = ImGui::CreateContext(state->fonts.get());
    ImGui::GetIO().IniFilename = nullptr; // the preferences hold what is kept
    ImGui_ImplGlfw_InitForOpenGL(state->window, true);
    takeKeys(state->window);
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
    if (std::exchange(state_->title, title) !=
        title) // the window manager answers with an event, which would be a frame
        glfwSetWindowTitle(state_->window, title.c_str());
}

void Window::giveArrowsToPicture(bool wanted)
{
    state_->arrowsForPicture = wanted;
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
    releaseKeys(*state_);
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
