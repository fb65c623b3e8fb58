// How cost grows with triangles, pixels, lights, samples and the size of a table: measured, with the exponent that fits.
#pragma once

#include "core/chart/chart.h"
#include "core/study/bench/bench.h"

#include <string>
#include <vector>

namespace reflectance {

struct Growth {
    std::string with; ///< what grows: "triangles"
    std::string cost; ///< what of: "first frame, simd"
    std::vector<double> sizes;
    std::vector<Timing> milliseconds;

    /// The slope of a straight line through log(cost) over log(size) by least squares: 1 where cost is in proportion.
    [[nodiscard]] double exponent() const;
};

/// GL only where a renderer is given; its context must be current.
[[nodiscard]] Result<std::vector<Growth>> growths(GlRenderer* gl, bool quick, Progress& progress);

/// Cost over size, both relative to the smallest of each and on logarithmic axes, with the exponents in the legend.
[[nodiscard]] Chart chartOf(const std::vector<Growth>& growths);

} // namespace reflectance
