// The desktop's side of the program: a GLFW window with a GL 3.3 core context, and Dear ImGui in it.
#pragma once

#include "app/explorer/gestures.h"
#include "app/explorer/keys.h"
#include "core/base/result.h"
#include "core/render/headless/headless_context.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// GLFW, from its start to its end. Nothing where there is no display.
class Desktop {
public:
    [[nodiscard]] static std::optional<Desktop> connect();
    Desktop(Desktop&& other) noexcept;
    Desktop& operator=(Desktop&&) = delete;
    ~Desktop();

private:
    Desktop() = default;
    bool owned_ = true;
};

/// What happened since the last call.
struct Events {
    std::vector<KeyPress> keys;       ///< those that no text field took
    std::vector<std::string> dropped; ///< files
};

struct WindowState;

class Window {
public:
    /// Size in points at scale 1; `scale` 0 takes the monitor's.
    [[nodiscard]] static Result<Window> open(int width, int height, float scale);
    Window(Window&&) noexcept;
    Window& operator=(Window&&) = delete;
    ~Window();

    /// Sleeps until something happens, at most so many seconds; 0 only looks. Infinity sleeps without end.
    /// True if something happened; false after the time, and after news from the desktop that concern no picture.
    bool wait(double seconds);
    [[nodiscard]] Events takeEvents();
    [[nodiscard]] bool closing() const;
    void setTitle(const std::string& title);
    void giveArrowsToPicture(bool wanted); ///< instead of to the controls, until Tab goes to one of them

    void beginFrame(); ///< starts an ImGui frame; renews the fonts when the window has moved to another scale
    void drawFrame();  ///< ends the ImGui frame and draws it
    void showFrame();  ///< shows what was drawn

    [[nodiscard]] ViewSize size() const;          ///< points
    [[nodiscard]] ViewSize framebuffer() const;   ///< pixels
    [[nodiscard]] float pixelsPerPoint() const;   ///< 1 on X11; the monitor's scale where the desktop scales
    [[nodiscard]] float scale() const;            ///< of the interface, in points
    [[nodiscard]] static GetProcAddress loader(); ///< of the current context

    /// Wakes wait() from any thread.
    static void wake();

private:
    explicit Window(std::unique_ptr<WindowState> state);
    std::unique_ptr<WindowState> state_;
};

} // namespace reflectance::explorer
