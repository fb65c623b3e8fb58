#include "app/explorer/pictures.h"

#include "app/explorer/user_folders.h"
#include "core/image/picture_file.h"
#include "core/sensor/picture.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace reflectance::explorer {
namespace {

std::string chosenPath(const ExplorerState& state, const std::string& path)
{
    if (!path.empty())
        return path;
    return freeName(picturesFolder(), state.scene.mesh->name, state.scene.surface.model, ".png").string();
}

/// The current framebuffer, rows from the top.
std::vector<std::uint8_t> readFramebuffer(ViewSize size, GetProcAddress load)
{
    const auto pixelStorei = reinterpret_cast<PFNGLPIXELSTOREIPROC>(load("glPixelStorei"));
    const auto readPixels = reinterpret_cast<PFNGLREADPIXELSPROC>(load("glReadPixels"));
    const auto rowBytes = 3 * static_cast<std::ptrdiff_t>(size.width);
    std::vector<std::uint8_t> rgb(static_cast<std::size_t>(rowBytes) * static_cast<std::size_t>(size.height));
    pixelStorei(GL_PACK_ALIGNMENT, 1);
    readPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    for (auto low = rgb.begin(), high = rgb.end() - rowBytes; low < high; low += rowBytes, high -= rowBytes)
        std::swap_ranges(low, low + rowBytes, high);
    return rgb;
}

} // namespace

Result<std::string> saveViewPicture(const ExplorerState& state, const Viewport& viewport, GlRenderer& renderer,
                                    const std::string& path)
{
    if (const Result<void> rendered = renderFully(state, viewport, renderer); !rendered)
        return rendered.error();
    const std::string chosen = chosenPath(state, path);
    if (const auto saved = savePicture(chosen, renderer.readLinear(), state.scene.sensor); !saved)
        return saved.error();
    return chosen;
}

Result<std::string> saveWindowPicture(const ExplorerState& state, ViewSize size, GetProcAddress load,
                                      const std::string& path)
{
    const std::vector<std::uint8_t> rgb = readFramebuffer(size, load);
    const std::string chosen = chosenPath(state, path);
    if (const Result<void> written = writePng(chosen, size.width, size.height, rgb); !written)
        return written.error();
    return chosen;
}

} // namespace reflectance::explorer
