#include "core/measured/grid_rows.h"

#include "core/base/text.h"

#include <algorithm>

namespace reflectance {

Result<void> GridRows::add(std::span<const double> angles)
{
    const std::size_t width = names_.size();
    if (!rows_.empty()) {
        const auto last = std::span(rows_).last(width);
        if (std::equal(angles.begin(), angles.end(), last.begin()))
            return Error{"these angles stand here for the second time; keep one row of them"};
        if (!std::lexicographical_compare(last.begin(), last.end(), angles.begin(), angles.end()))
            return Error{"the rows are not sorted; sort them by " + joined(names_, ", then ") + ", ascending"};
    }
    rows_.insert(rows_.end(), angles.begin(), angles.end());
    return {};
}

Result<std::vector<std::vector<double>>> GridRows::axes() const
{
    const std::size_t width = names_.size();
    const std::size_t rows = rows_.size() / width;
    std::vector<std::vector<double>> axes(width);
    double cells = 1.0; // as a double: the product of three counts may be larger than any integer
    for (std::size_t column = 0; column < width; ++column) {
        auto& axis = axes[column];
        for (std::size_t row = 0; row < rows; ++row)
            axis.push_back(rows_[row * width + column]);
        std::sort(axis.begin(), axis.end());
        axis.erase(std::unique(axis.begin(), axis.end()), axis.end());
        axis.shrink_to_fit();
        cells *= static_cast<double>(axis.size());
    }
    // Different rows in ascending order, as many as the product has: they are the product.
    if (cells == static_cast<double>(rows))
        return axes;
    std::vector<std::string> counts;
    for (const auto& axis : axes)
        counts.push_back(std::to_string(axis.size()));
    return Error{"has " + std::to_string(rows) + " rows, but its angles make a grid of " + joined(counts, " x ") +
                 "; the first one missing is " + firstMissing(axes) + "; write nan where nothing was measured"};
}

std::string GridRows::firstMissing(const std::vector<std::vector<double>>& axes) const
{
    const std::size_t width = names_.size();
    std::vector<std::size_t> at(width, 0);
    for (std::size_t row = 0;; ++row) {
        bool isThere = (row + 1) * width <= rows_.size();
        std::string text;
        for (std::size_t column = 0; column < width; ++column) {
            const double expected = axes[column][at[column]];
            isThere = isThere && rows_[row * width + column] == expected;
            text += (column > 0 ? ", " : "") + names_[column] + " = " + general(expected, 9);
        }
        if (!isThere)
            return text;
        for (std::size_t column = width; column-- > 0;) { // the next cell, last column fastest
            if (++at[column] < axes[column].size())
                break;
            at[column] = 0;
        }
    }
}

} // namespace reflectance
