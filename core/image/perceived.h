// How visible the difference of two pictures is: dE2000 over pixels, and FLIP.
#pragma once

#include "core/image/colour_difference.h"
#include "core/image/flip.h"
#include "core/image/image.h"

#include <vector>

namespace reflectance {

/// Of pictures as a display shows them: channels kept within 0 .. 1. What was clamped is invisible here, so look at the
/// linear figures as well.
struct PerceivedDifference {
    double deltaEMean = 0.0, deltaEP95 = 0.0, deltaEMax = 0.0; ///< dE2000
    double flipMean = 0.0;                                     ///< over the whole picture, at the usual distance
};

/// Which pixels the dE2000 figures are taken over.
enum class Over { AllPixels, CoveredPixels };

/// The reference, prepared once for many comparisons.
class PerceivedReference {
public:
    explicit PerceivedReference(const Image& reference, Over over = Over::AllPixels);

    /// The sizes must match.
    [[nodiscard]] PerceivedDifference to(const Image& test) const;
    /// dE2000 of one pixel.
    [[nodiscard]] double deltaEAt(std::size_t pixel, const Image& test) const;

private:
    std::vector<Lab> colours_;
    std::vector<std::size_t> pixels_;
    FlipReference flip_;
};

} // namespace reflectance
