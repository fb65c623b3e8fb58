// The library of surfaces as the workbench shows it: what is looked for, the pictures made so far, and the way back from
// an applied surface.
#pragma once

#include "app/explorer/comparison.h"
#include "core/render/progress.h"
#include "core/study/properties/light_budget.h"
#include "core/surfaces/library.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

inline constexpr int thumbnailSize = 112; ///< pixels a side

/// A sphere of one surface under the scene's lights, and how much light it returns.
struct Thumbnail {
    std::string id;
    std::vector<std::uint8_t> rgb; ///< rows from the top
    properties::LightBudget budget;
};

/// Nothing where `progress` was cancelled.
[[nodiscard]] std::optional<std::vector<Thumbnail>>
makeThumbnails(const Scene& lit, const std::vector<std::string>& ids, Progress& progress);

struct ShelfPicture {
    unsigned texture = 0;
    properties::LightBudget budget;
    bool stale = false; ///< made under other lights
};

struct SurfaceShelf {
    std::string search;
    std::string group;                                         ///< id; empty: all
    std::map<std::string, ShelfPicture, std::less<>> pictures; ///< by the surface's id
    std::vector<std::string> wanted; ///< on screen in the last frame, and without a picture under these lights
    std::optional<Surface> before;   ///< what the first of the applied surfaces replaced
    Surface applied;                 ///< as it was applied: changed by hand, the way back is closed
};

/// Gives the variant in hand this surface.
void applyFromShelf(SurfaceShelf& shelf, const LibrarySurface& from, Surface& inHand);

/// True while the surface in hand is the one that was applied.
[[nodiscard]] bool canGoBack(const SurfaceShelf& shelf, const Surface& inHand);
void goBack(SurfaceShelf& shelf, Surface& inHand);

} // namespace reflectance::explorer
