// Reads the text of one group of surfaces: comment lines "# key value", then a table parted by commas. A column named as
// a parameter of the model holds its numbers, parted by blanks; any other column is kept as a fact.
#pragma once

#include "core/surfaces/library.h"

namespace reflectance {

/// `id` is the group's; `file` stands in errors. Keys: group, model, source, convention, note; "scale NAME a b c" multiplies
/// what the column of that parameter holds, channel by channel; "set NAME=VALUE" holds for every surface.
[[nodiscard]] Result<std::vector<LibrarySurface>> parseSurfaceGroup(std::string_view id, std::string_view text,
                                                                    const std::string& file);

} // namespace reflectance
