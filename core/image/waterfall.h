// How much of the difference between a picture and the truth comes from each step on the way from one to the other.
#pragma once

#include "core/base/result.h"
#include "core/image/image.h"

#include <span>
#include <string>
#include <vector>

namespace reflectance {

/// A picture on the way, and what was done to get there from the one before.
struct WaterfallPicture {
    std::string step;
    Image image; ///< linear
};

/// Over all channels that are finite in every picture. With d the change that a step makes and D the change that all make
/// together, share = sum(d D) / sum(D D): shares of all steps add up to 1, and a step that undoes what another did has a negative
/// one.
struct WaterfallStep {
    std::string step;
    double rmse = 0.0, maxAbs = 0.0; ///< of d
    double share = 0.0;              ///< 0 where D is 0 everywhere
};

struct Waterfall {
    std::vector<WaterfallStep> steps;
    double rmse = 0.0, maxAbs = 0.0; ///< of D
    std::size_t leftOut = 0;         ///< channels that are not finite somewhere
};

/// The first picture is the truth. Refuses fewer than two, and pictures of different size.
[[nodiscard]] Result<Waterfall> waterfallOf(std::span<const WaterfallPicture> pictures);

} // namespace reflectance
