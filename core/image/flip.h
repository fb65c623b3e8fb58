// FLIP: how strongly two pictures, flipped back and forth on a screen, would differ to the eye.
#pragma once

#include "core/image/image.h"

#include <memory>
#include <vector>

namespace reflectance {

/// Pixels per degree of a 0.7 m wide 4K screen seen from 0.7 m: the figure's usual condition.
inline constexpr double usualPixelsPerDegree = 67.0;

/// The reference picture, prepared once for many comparisons.
///
/// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild, FLIP: A Difference Evaluator for Alternating
/// Images, Proc. ACM CGIT 3(2), 2020; the version for displayed pictures: channels are kept within 0 .. 1, NaN is 0.
class FlipReference {
public:
    explicit FlipReference(const Image& reference, double pixelsPerDegree = usualPixelsPerDegree);
    ~FlipReference();
    FlipReference(FlipReference&&) noexcept;
    FlipReference& operator=(FlipReference&&) noexcept;

    /// 0 (equal) .. 1 per pixel, rows from the top. The sizes must match.
    [[nodiscard]] std::vector<float> mapOf(const Image& test) const;
    /// The mean of the map.
    [[nodiscard]] double meanOf(const Image& test) const;

private:
    struct Prepared;
    std::unique_ptr<Prepared> prepared_;
};

} // namespace reflectance
