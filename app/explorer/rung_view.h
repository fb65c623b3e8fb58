// The picture of a variant that names how it is drawn: rungs are applied on a thread, which also draws what the CPU draws; the
// window never waits for either.
#pragma once

#include "app/explorer/screen_texture.h"
#include "app/explorer/worker.h"
#include "core/render/gl/gl_renderer.h"
#include "core/sensor/sensor.h"
#include "core/study/trade/rung.h"
#include "core/study/trade/workshop.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace reflectance::explorer {

/// A variant with its rungs applied, and its picture where the CPU drew it.
struct RungPicture {
    Recipe recipe;
    std::vector<SkippedRung> withoutEffect;
    std::optional<Image> image; ///< linear
    std::optional<Developed> codes;
    std::string problem; ///< why there is no picture
};

/// What GL saw of the view, to be shaded by the CPU; null where the CPU looks itself.
using SeenByGl = std::function<std::shared_ptr<const ViewSamples>()>;

class RungView {
public:
    RungView(GetProcAddress load, std::function<void()> wake) : load_(load), texture_(load), work_(std::move(wake)) {}

    /// Shows what has come and asks for what is missing; the last picture stays until the next one is there. The window's context
    /// must be current.
    [[nodiscard]] Result<void> update(const Scene& variant, const RenderSettings& settings, const SeenByGl& seen);
    /// The variant has no rungs any more.
    void drop();

    [[nodiscard]] unsigned texture() const; ///< 0 before the first picture
    [[nodiscard]] bool rowsFromTop() const; ///< of that texture
    [[nodiscard]] bool current() const;     ///< the picture is of what update() was called for last
    [[nodiscard]] Image linear();           ///< of the whole picture's size
    [[nodiscard]] std::uint64_t pictures() const { return pictures_; } ///< how many different ones were shown
    [[nodiscard]] const std::vector<SkippedRung>& withoutEffect() const { return withoutEffect_; }

private:
    struct Wanted {
        Scene variant;
        RenderSettings settings;
        bool seenByGl = false;
    };
    void start(const Wanted& wanted, std::shared_ptr<const ViewSamples> seen);
    [[nodiscard]] Result<void> show(RungPicture picture);

    GetProcAddress load_;
    std::optional<GlRenderer> renderer_; ///< made when a recipe of GL's comes first
    ScreenTexture texture_;              ///< what the CPU drew
    Worker<RungPicture> work_;
    std::shared_ptr<Workshop> workshop_; ///< the worker's, kept while view and size stay
    std::optional<Wanted> asked_, shown_, wanted_;
    std::optional<RungPicture> picture_; ///< the one shown
    std::vector<SkippedRung> withoutEffect_;
    std::uint64_t pictures_ = 0;
};

/// One picture of a variant with rungs, waited for: for a file. `gl` draws recipes of GL's, and looks for the CPU where `seen` is set.
[[nodiscard]] Result<Image> pictureByRungs(const Scene& variant, const RenderSettings& settings, GlRenderer& gl,
                                           const std::shared_ptr<const ViewSamples>& seen);

} // namespace reflectance::explorer
