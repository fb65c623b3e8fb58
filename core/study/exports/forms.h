// The three forms of an exported model. Internal to the exports.
#pragma once

#include "core/study/exports/export_model.h"

namespace reflectance::exports {

[[nodiscard]] std::string glslForm(const ExportSubject& subject);
[[nodiscard]] std::string cppForm(const ExportSubject& subject);
[[nodiscard]] std::string csvForm(const ExportSubject& subject);

} // namespace reflectance::exports
