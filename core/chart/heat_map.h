// A map of numbers over two axes as a value, drawn in the window and on paper from the same numbers.
#pragma once

#include "core/chart/chart.h"

namespace reflectance {

struct HeatMap {
    std::string title;
    Axis x, y; ///< ends at the outer edges of the outermost cells
    std::size_t columns = 0, rows = 0;
    std::vector<double> values; ///< row by row from the low end of y; NaN is a hole
    Axis scale;                 ///< of the values; its label names them
    bool diverging = false;     ///< colours tell signs: scale.low = -scale.high

    [[nodiscard]] double at(std::size_t column, std::size_t row) const { return values[row * columns + column]; }
};

/// The colour of a number on the map's scale; what is beyond an end is shown as that end.
[[nodiscard]] ChartColor colorOf(const HeatMap& map, double value);

/// The cell at a place given in the axes' own numbers; false where it lies outside.
[[nodiscard]] bool cellAt(const HeatMap& map, double x, double y, std::size_t& column, std::size_t& row);

/// Holes are hatched.
[[nodiscard]] std::string svgOf(const HeatMap& map, int width, int height);

/// A line per cell, "x,y,value" with the cell's middle; holes have no value.
[[nodiscard]] std::string csvOf(const HeatMap& map);

} // namespace reflectance
