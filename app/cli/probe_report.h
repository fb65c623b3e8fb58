// The figures of a probe.
#pragma once

#include "core/study/probe/probe.h"

#include <nlohmann/json_fwd.hpp>

namespace reflectance::cli {

[[nodiscard]] nlohmann::ordered_json probeReport(const Probe& probe);

} // namespace reflectance::cli
