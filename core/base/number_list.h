// Lists of numbers in a text: "0.2, 0.3, 0.4" or "0.2 0.3 0.4".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace reflectance {

/// Finite numbers parted by commas, blanks around them left out; nothing where a piece is no such number.
[[nodiscard]] std::optional<std::vector<double>> numberList(std::string_view text);

/// The same parted by blanks and tabs; a text of nothing else is a list of none.
[[nodiscard]] std::optional<std::vector<double>> numbersInWords(std::string_view text);

} // namespace reflectance
