// Pictures of variants that name how they are drawn: each by its own rungs.
#pragma once

#include "core/render/gl/gl_renderer.h"
#include "core/render/pictures/render_picture.h"
#include "core/scene/kept_picture.h"
#include "core/study/trade/rung.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::cli {

/// Whether a surface that is shown has rungs.
[[nodiscard]] bool asksForRungs(const Scene& scene, VariantView shown);

class RungPictures {
public:
    /// `plan`: how a variant is drawn whose rungs say nothing about it.
    RungPictures(const Scene& scene, VariantView shown, const RenderPlan& plan);

    /// Where GL draws the variant beside it, a picture by the CPU shades the samples that GL saw: what separates the two is then
    /// arithmetic, and no edge that one of them sees elsewhere.
    [[nodiscard]] Result<Rendered> render(const Scene& variant, const RenderSettings& settings);

    /// Who draws what says nothing: "gl (osmesa)", "glsl".
    [[nodiscard]] std::string backend() const;
    [[nodiscard]] std::string precision() const;

    /// Rungs that changed nothing, and why.
    [[nodiscard]] const std::vector<SkippedRung>& withoutEffect() const { return withoutEffect_; }

private:
    [[nodiscard]] Result<void> openGl();
    [[nodiscard]] bool besideGl(const Scene& variant) const;
    [[nodiscard]] Result<Rendered> drawn(const Recipe& recipe, std::shared_ptr<const ViewSamples> seen);

    Scene scene_;
    bool both_; ///< A and B are in one picture
    RenderPlan plan_;
    std::unique_ptr<HeadlessContext> context_;
    std::optional<GlRenderer> renderer_;
    bool onGl_ = false; ///< what says nothing
    std::vector<SkippedRung> withoutEffect_;
};

} // namespace reflectance::cli
