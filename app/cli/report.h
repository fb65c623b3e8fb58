// Figures as JSON, where a verb was given --json FILE or --json -.
#pragma once

#include "core/base/result.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace reflectance::cli {

/// Writes the report to the file, or to stdout for "-"; does nothing for "".
[[nodiscard]] Result<void> writeReport(const std::string& target, const nlohmann::ordered_json& report);

} // namespace reflectance::cli
