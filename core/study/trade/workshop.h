// Makes the pictures of recipes, and keeps for each what a drag would keep: what was seen. Recipes that see alike share it.
#pragma once

#include "core/image/image.h"
#include "core/render/cpu/shading_places.h"
#include "core/render/gl/gl_renderer.h"
#include "core/study/trade/recipe.h"

#include <map>
#include <memory>
#include <tuple>

namespace reflectance {

/// A recipe that has been drawn once and can be shaded again.
struct Prepared {
    Recipe recipe;
    PlacedView view;                            ///< CPU
    std::shared_ptr<const PlacedView> bodyView; ///< CPU, where the highlight is shaded elsewhere
    double lookMilliseconds = 0.0;              ///< to see what is shaded, the mesh being in place
    std::size_t shadings = 0;                   ///< evaluations of the model per light
    std::size_t bytes = 0;                      ///< kept between two shadings, besides mesh and scene
};

/// How GL shades a recipe.
[[nodiscard]] GlShading glShadingOf(const Recipe& recipe);

class Workshop {
public:
    /// All recipes show one mesh by one camera. The renderer's context must be current while GL recipes are worked on; null:
    /// there are none.
    Workshop(std::shared_ptr<const Mesh> mesh, const Camera& camera, GlRenderer* gl);

    /// What is seen, by whoever looked: CPU recipes of that size and sampling shade it, and look no more themselves.
    void look(std::shared_ptr<const ViewSamples> samples);

    [[nodiscard]] Result<Prepared> prepare(const Recipe& recipe);

    /// The recipe's picture.
    [[nodiscard]] Result<Image> picture(const Prepared& prepared);

    /// Milliseconds of shading what is seen again, upscaling included on the CPU (a GPU does it while showing the picture).
    [[nodiscard]] Result<double> shadingTime(const Prepared& prepared);

    /// The double picture with 8 x 8 samples per pixel, none of them kept. Stopped where progress says so, of which it is a share.
    [[nodiscard]] static Image truth(const Scene& scene, const RenderSettings& settings, Progress* progress,
                                     double share = 1.0);

    [[nodiscard]] double meshMilliseconds() const
    {
        return meshMilliseconds_;
    } ///< of Embree's structure, once per mesh
    [[nodiscard]] bool hasGl() const { return gl_ != nullptr; }

private:
    using ViewKey = std::tuple<int, int, int>;
    struct Seen {
        std::shared_ptr<const ViewSamples> samples;
        double milliseconds = 0.0;
    };
    [[nodiscard]] const Seen& seen(const RenderSettings& settings);
    [[nodiscard]] Image shadedOnCpu(const Prepared& prepared) const;
    [[nodiscard]] Result<void> drawOnGl(const Prepared& prepared);

    std::shared_ptr<const Mesh> mesh_;
    Camera camera_;
    GlRenderer* gl_;
    std::shared_ptr<const RayScene> rays_; ///< made when a recipe first needs it
    double meshMilliseconds_ = 0.0;
    std::map<ViewKey, Seen> views_;
};

} // namespace reflectance
