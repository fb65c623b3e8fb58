// What the goniometer measured, for people and for scripts.
#pragma once

#include "core/study/goniometer/formula_gap.h"

#include <nlohmann/json_fwd.hpp>

namespace reflectance::cli {

/// A formula that the run was compared with.
struct Compared {
    std::string name;
    FormulaGap gap;
};

void print(const LabRun& run, const MicroSurface& surface, const std::optional<Compared>& compared);

[[nodiscard]] nlohmann::ordered_json described(const LabRun& run, const MicroSurface& surface,
                                               const std::optional<Compared>& compared);

} // namespace reflectance::cli
