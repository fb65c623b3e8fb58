// Which part of the formula costs a pixel its digits, in words.
#pragma once

#include "core/study/lens/lens.h"

#include <string>

namespace reflectance {

/// A pixel under the lens.
struct LensReading {
    LensPixel pixel;
    Vec3d exact, got;   ///< of the pixel, linear
    double kappa = 0.0; ///< what rounding is magnified by, of the pixel's most sensitive sample and channel
    std::string term;   ///< "R.V = 1, n = 1e+06: the lobe", "N.L = 1e-07: within 4 eps of the horizon"
};

/// `image` is the view's picture in the arithmetic `kind`, `map` its map. Cheap enough for every movement of a mouse.
[[nodiscard]] LensReading readingAt(LensKind kind, const LensMap& map, const ViewSamples& samples, const Image& image,
                                    const Scene& scene, int x, int y);

} // namespace reflectance
