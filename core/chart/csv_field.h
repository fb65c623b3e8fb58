// Names in CSV, whatever they hold.
#pragma once

#include <string>

namespace reflectance {

/// A field of a comma-separated line: quoted where it must be.
[[nodiscard]] std::string csvField(const std::string& text);

} // namespace reflectance
