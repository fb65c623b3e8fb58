// A list whose rows can be removed, and which scrolls when it is long: of lights, of variants.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace reflectance::explorer {

/// Draws `count` rows, five of them at a time; `drawRow` is true where its row is to be removed. Returns that row. `more` is the
/// scroll bar's tooltip.
[[nodiscard]] std::optional<std::size_t> rowList(const char* id, std::size_t count, const char* more,
                                                 const std::function<bool(std::size_t)>& drawRow);

} // namespace reflectance::explorer
