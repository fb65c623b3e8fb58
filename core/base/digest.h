// A short name for long contents.
#pragma once

#include <string>
#include <string_view>

namespace reflectance {

/// FNV-1a, 64 bits, as 16 hexadecimal digits: tells contents apart, not meant to withstand malice.
[[nodiscard]] std::string digestOf(std::string_view contents);

} // namespace reflectance
