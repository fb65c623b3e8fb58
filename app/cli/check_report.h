// The figures of `check` as JSON.
#pragma once

#include "core/study/properties/check.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace reflectance::cli {

/// "ks=1;n=40, light at 80 degrees (double)".
[[nodiscard]] std::string placeText(const ModelText& model, const properties::Place& place);

[[nodiscard]] nlohmann::ordered_json described(const ModelText& model, const properties::PropertyResult& result);

/// What can be said of a colour matrix's default.
[[nodiscard]] nlohmann::ordered_json matrixReport(const Parameter& matrix);

} // namespace reflectance::cli
