// Functions on the unit square, bilinear between the nodes of a regular grid; and the warp that such a density makes.
#pragma once

#include <cstddef>
#include <vector>

namespace reflectance {

/// Nodes at even steps from 0 to 1 in x (fastest) and y, at least two each.
struct BilinearGrid {
    std::size_t width = 0, height = 0;
    std::vector<float> nodes;

    [[nodiscard]] double at(double x, double y) const;
};

struct UnitPoint {
    double x = 0.0, y = 0.0;
};

/// The bilinear density f >= 0 (not normalised) and its integrals, exact: along a row they are piecewise quadratic.
class WarpedSquare {
public:
    WarpedSquare() = default;
    explicit WarpedSquare(BilinearGrid density);

    /// Of all of f.
    [[nodiscard]] double total() const { return belowRow_.back(); }

    /// Integral of f over x' < x at this y.
    [[nodiscard]] double leftOf(double x, double y) const;
    /// Integral of f over all x at this y.
    [[nodiscard]] double across(double y) const;
    /// Integral of f over all x and y' < y.
    [[nodiscard]] double below(double y) const;

private:
    BilinearGrid density_;
    std::vector<double> leftOfNode_; ///< at every node: integral along its row up to it
    std::vector<double> belowRow_;   ///< at every row: integral below it
};

} // namespace reflectance
