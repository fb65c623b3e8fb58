// What the window shows beside A as GL draws it: variant B, what rungs make of A and B, and the map of what separates them.
#pragma once

#include "app/explorer/difference.h"
#include "app/explorer/rung_view.h"
#include "app/explorer/screen_texture.h"
#include "app/explorer/worker.h"
#include "core/render/gl/gl_renderer.h"

#include <functional>
#include <optional>

namespace reflectance::explorer {

/// B is drawn by a renderer of its own: while a light is dragged, both keep their samples and their buffers.
/// A picture that the window can show.
struct ShownTexture {
    unsigned id = 0; ///< 0: none yet
    bool rowsFromTop = false;
};

struct SecondView {
    SecondView(GetProcAddress loader, const std::function<void()>& wake)
        : load(loader), rungsA(loader, wake), rungsB(loader, wake), map(loader), work(wake)
    {
    }

    GetProcAddress load;
    std::optional<GlRenderer> renderer; ///< made when first needed
    RungView rungsA, rungsB;            ///< in use where the surface has rungs
    ScreenTexture map;                  ///< of the signed difference
    Worker<DifferencePicture> work;
    std::uint64_t measured = 0;     ///< Viewport::pictures when the difference was last asked for
    bool measuredPerceived = false; ///< with dE2000 and FLIP
    std::optional<Region> measuredRegion;

    /// Brings the pictures up to date: of B, where it is compared, and of what has rungs. `first` has drawn the scene, A.
    [[nodiscard]] Result<void> render(const Scene& scene, bool comparing, const RenderSettings& settings,
                                      GlRenderer& first);
    /// B without rungs, by the renderer that is B's.
    [[nodiscard]] Result<void> renderB(const Scene& b, const RenderSettings& settings);
    [[nodiscard]] std::uint64_t pictures() const; ///< how many different ones were drawn

    /// The scene decides whether rungs make the picture; while their first one is made, it is the one without.
    [[nodiscard]] ShownTexture shownA(const Scene& scene, const GlRenderer& first) const;
    [[nodiscard]] ShownTexture shownB(const Scene& scene, const GlRenderer& first) const;
    [[nodiscard]] Image linearA(const Scene& scene, GlRenderer& first);
    [[nodiscard]] Image linearB(const Scene& scene);
    [[nodiscard]] bool current(const Scene& scene) const; ///< nothing is still being drawn by rungs
};

} // namespace reflectance::explorer
