// Rows of angles that have to make up a whole grid: sorted, none twice, none missing. Internal to the readers.
#pragma once

#include "core/base/result.h"

#include <span>
#include <string>
#include <vector>

namespace reflectance {

class GridRows {
public:
    /// The names of the columns, the slowest first, for sentences.
    explicit GridRows(std::vector<std::string> names) : names_(std::move(names)) {}

    /// Takes a row whose angles come after those of the last one; else the sentence that says what is wrong with it.
    [[nodiscard]] Result<void> add(std::span<const double> angles);

    /// The different values of each column, ascending, if the rows are their whole product.
    [[nodiscard]] Result<std::vector<std::vector<double>>> axes() const;

private:
    [[nodiscard]] std::string firstMissing(const std::vector<std::vector<double>>& axes) const;

    std::vector<std::string> names_;
    std::vector<double> rows_;
};

} // namespace reflectance
