// The program's version, as what it writes names it.
#pragma once

#include <string_view>

namespace reflectance {

/// "0.1.0"
[[nodiscard]] std::string_view programVersion();

} // namespace reflectance
