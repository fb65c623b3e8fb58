// Pictures of the view and of the window, as PNG files.
#pragma once

#include "app/explorer/second_view.h"
#include "app/explorer/viewport.h"
#include "core/base/result.h"

#include <string>

namespace reflectance::explorer {

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
