// The picture of variant B, and the map of what separates it from A's.
#pragma once

#include "app/explorer/difference.h"
#include "app/explorer/screen_texture.h"
#include "app/explorer/worker.h"
#include "core/render/gl/gl_renderer.h"

#include <functional>
#include <optional>

namespace reflectance::explorer {

/// B is drawn by a renderer of its own: while a light is dragged, both keep their samples and their buffers.
struct SecondView {
    SecondView(GetProcAddress loader, std::function<void()> wake) : load(loader), map(loader), work(std::move(wake)) {}

    GetProcAddress load;
    std::optional<GlRenderer> renderer; ///< made when first needed
    ScreenTexture map;                  ///< of the signed difference
    Worker<DifferencePicture> work;
    std::uint64_t measured = 0;     ///< Viewport::pictures when the difference was last asked for
    bool measuredPerceived = false; ///< with dE2000 and FLIP
    std::optional<Region> measuredRegion;

    /// Brings B's picture up to date.
    [[nodiscard]] Result<void> render(const Scene& b, const RenderSettings& settings);
    [[nodiscard]] std::uint64_t pictures() const; ///< how many different ones were drawn
};

} // namespace reflectance::explorer
