// Build step: reading what it works on.
#pragma once

#include <string>

namespace reflectance::tools {

/// The whole file; empty if it cannot be read.
[[nodiscard]] std::string contents(const std::string& path);

} // namespace reflectance::tools
