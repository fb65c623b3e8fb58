// A run of the goniometer as a text file that people can read: where it stands, so that it goes on as if never stopped.
#pragma once

#include "core/study/goniometer/laboratory.h"

#include <string_view>

namespace reflectance {

/// The first line names format and version; then a line per fact, angles in radians, numbers to the last bit.
[[nodiscard]] std::string checkpointText(const LabRun& run);

/// The inverse. Refused, with the line: another version, a fact that is missing, twice or unknown, counts that do not fit.
[[nodiscard]] Result<LabRun> readCheckpoint(std::string_view text, const std::string& file);

} // namespace reflectance
