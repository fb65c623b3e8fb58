// A run of the goniometer by processes: of this machine, or of all ranks of mpirun. One that dies costs a cell.
#pragma once

#include "core/study/goniometer/lab_pass.h"

namespace reflectance {

/// As measure(), with the same numbers, for any number of processes: `workers` in each rank, or one per core where that is 0. In a
/// rank that is not the first this works for the first. Gives the cells of which processes died, which are left as they were
/// before; the Error says why there are no processes, or none any more.
[[nodiscard]] Result<LabFailures> measureWithCrew(LabRun& run, const MicroTracer& tracer, const LabTargets& targets,
                                                  unsigned workers, Progress* progress = nullptr,
                                                  const LabWatch& watch = {});

} // namespace reflectance
