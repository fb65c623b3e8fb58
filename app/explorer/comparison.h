// Two variants of one scene, A and B: what is seen of them and which one the hand changes. Camera, lights, object and
// sensor they share.
#pragma once

#include "app/explorer/difference.h"
#include "app/explorer/layout.h"
#include "core/scene/scene.h"

#include <optional>
#include <vector>

namespace reflectance::explorer {

enum class CompareMode { SideBySide, Wipe, Flip, Difference };

/// What the clay view replaced.
struct BeforeClay {
    Surface surface;
    std::optional<Surface> other;
    std::vector<Light> lights;
    Camera camera;
    bool comparing = false;
    CompareMode mode = CompareMode::SideBySide;

    friend bool operator==(const BeforeClay&, const BeforeClay&) = default;
};

struct CompareView {
    bool on = false; ///< the scene then has a variant B
    CompareMode mode = CompareMode::SideBySide;
    bool handOnB = false;                     ///< the panel changes B; Flip shows it
    float divider = 0.5F;                     ///< Wipe: A's share of the width
    bool holdsDivider = false;                ///< the mouse has it
    std::optional<DifferenceFigures> figures; ///< of the last pictures; none before they are measured
    double scale = 0.0;                       ///< of the difference map, linear; 0 before the first
    std::optional<Region> region;             ///< of each pane: where the figures are taken; none: the whole object
    Region regionStart;                       ///< its first corner, while it is drawn
    bool drawsRegion = false;                 ///< the mouse draws it
    std::optional<BeforeClay> beforeClay;
};

/// Where A and B stand in the picture's area: side by side, or each the whole of it.
struct Panes {
    Area a, b;
};
[[nodiscard]] Panes panesOf(const CompareView& compare, const Area& area, float scale);

/// Switches the comparison; the first time B starts as a copy of A. B stays with the scene when it is not looked at.
void toggleCompare(CompareView& compare, Scene& scene);

/// The variant that the hand is on.
[[nodiscard]] Surface& surfaceInHand(const CompareView& compare, Scene& scene);
[[nodiscard]] const Surface& surfaceInHand(const CompareView& compare, const Scene& scene);

/// A becomes B and B becomes A.
void swapVariants(Scene& scene);

/// Rough clay as Oren and Nayar photographed it: Lambert as A and Oren-Nayar as B, of equal albedo, lit from beside the
/// camera. A second call brings back surfaces, lights and camera as they were.
void toggleClay(CompareView& compare, Scene& scene);

} // namespace reflectance::explorer
