// What the status line says, as text in a long and a short form, and which form fits. No drawing.
#pragma once

#include "app/explorer/state.h"

#include <span>
#include <string>
#include <vector>

namespace reflectance::explorer {

struct StatusPart {
    std::string full;
    std::string brief;   ///< where there is little room
    std::string about;   ///< tooltip: everything, in sentences
    int weight = 0;      ///< parts of small weight are shortened first, and then left out
    bool isNews = false; ///< worth a look
};

/// Left: what is shown and how fast. Right: what was left out, and the price tags.
[[nodiscard]] std::vector<StatusPart> pictureParts(const ExplorerState& state);
[[nodiscard]] std::vector<StatusPart> priceParts(const ExplorerState& state);

enum class PartForm { Full, Brief, Gone };

/// The widths of a part's two forms, with the space around it.
struct PartWidth {
    float full = 0.0F, brief = 0.0F;
    int weight = 0;
};

/// Shortens, then drops, parts in the order of their weight until all fit.
[[nodiscard]] std::vector<PartForm> formsThatFit(std::span<const PartWidth> parts, float available);

} // namespace reflectance::explorer
