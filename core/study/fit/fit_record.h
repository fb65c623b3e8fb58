// The result of a fit as one line of text, to be sent from process to process and kept in a file.
#pragma once

#include "core/study/fit/fit.h"

#include <optional>
#include <string>
#include <string_view>

namespace reflectance {

/// Fields parted by tabs, numbers to the last bit; no end of line.
[[nodiscard]] std::string recordOf(const FitResult& fit);

/// The inverse; nothing where the text is no record.
[[nodiscard]] std::optional<FitResult> fitFromRecord(std::string_view record);

} // namespace reflectance
