// A run of the goniometer by processes: of this machine, or of all ranks of mpirun. One that dies costs a cell.
#pragma once

#include "core/study/crew/crew.h"
#include "core/study/goniometer/lab_pass.h"

namespace reflectance {

/// What a hand does for `setup`: the batches that it is asked for. Both are to outlive it.
[[nodiscard]] CrewWork labWork(const LabSetup& setup, const MicroTracer& tracer);

/// Passes by the hands of a crew, who do labWork(). A job is several cells; of one whose process dies each cell is tried alone, so
/// that one is to blame. `problem` becomes the Error of a crew that has no hands any more.
[[nodiscard]] LabPass passBy(Crew& crew, LabFailures& failures, Result<void>& problem);

/// As measure(), with the same numbers, for any number of processes: `workers` in each rank, or one per core where that is 0. In a
/// rank that is not the first this works for the first. Gives the cells of which processes died, which are left as they were
/// before; the Error says why there are no processes, or none any more.
[[nodiscard]] Result<LabFailures> measureWithCrew(LabRun& run, const MicroTracer& tracer, const LabTargets& targets,
                                                  unsigned workers, Progress* progress = nullptr,
                                                  const LabWatch& watch = {});

} // namespace reflectance
