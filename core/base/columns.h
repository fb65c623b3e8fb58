// Lines of CSV files as users write them.
#pragma once

#include <string_view>
#include <vector>

namespace reflectance {

/// The fields of a line, parted by commas, else semicolons, else tabs, each without blanks around it; else by blanks.
[[nodiscard]] std::vector<std::string_view> columnsOf(std::string_view line);

/// Without the mark (BOM) that some programs put before UTF-8.
[[nodiscard]] std::string_view withoutMark(std::string_view text);

} // namespace reflectance
