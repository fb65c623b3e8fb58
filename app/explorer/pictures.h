// Pictures of the view and of the window, as PNG files.
#pragma once

#include "app/explorer/second_view.h"
#include "app/explorer/viewport.h"
#include "core/base/result.h"

#include <optional>
#include <string>

namespace reflectance::explorer {

/// A part of the window, in pixels of the interface, and the name of a file for it, such as "curves.png".
struct WindowRegion {
    std::string name;
    float left = 0.0F, top = 0.0F, width = 0.0F, height = 0.0F;
};

/// "left top width height"; nothing where they are not four numbers or hold no pixel.
[[nodiscard]] std::optional<WindowRegion> regionFrom(const std::string& name, const std::string& text);

/// That part of the window as it has just been drawn, under a free name in the user's pictures folder. `scale`: pixels of the
/// framebuffer per pixel of the interface. Returns the path.
[[nodiscard]] Result<std::string> saveRegionPicture(const ExplorerState& state, const WindowRegion& region,
                                                    ViewSize framebuffer, float scale, GetProcAddress load);

/// The view with all its samples, without handles: read back as linear values and put through the sensor on the CPU.
/// While two variants are compared, what is seen of them. An empty path takes a free name in the user's pictures folder.
/// Returns the path.
[[nodiscard]] Result<std::string> saveViewPicture(const ExplorerState& state, const Viewport& viewport,
                                                  GlRenderer& renderer, SecondView& second, const std::string& path);

/// The window as it has just been drawn, before it is shown. `size` is that of the framebuffer. It carries the recipe of
/// the view in it.
[[nodiscard]] Result<std::string> saveWindowPicture(const ExplorerState& state, const Viewport& viewport, ViewSize size,
                                                    GetProcAddress load, const std::string& path);

} // namespace reflectance::explorer
