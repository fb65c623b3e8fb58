// Several pieces of work, timed in turns.
#pragma once

#include "core/render/progress.h"
#include "core/study/cost/timing.h"

#include <span>
#include <vector>

namespace reflectance {

/// Every piece once to warm up, then each `repetitions` times, one after the other. `units`: what one run counts for, so that
/// the timings are milliseconds per unit. Where the progress is cancelled, of what was done until then; `share` of it is done
/// when all is.
[[nodiscard]] std::vector<Timing> interleaved(std::span<const TimedWork> works, int repetitions, double units,
                                              Progress& progress, double share);

} // namespace reflectance
