// How a run of the goniometer is measured, pass after pass; who traces is for others to say: threads or processes.
#pragma once

#include "core/study/goniometer/laboratory.h"

#include <map>

namespace reflectance {

/// One more batch of a cell.
struct LabBatch {
    Channels f{}; ///< 1/sr
    std::uint64_t lost = 0;
};
[[nodiscard]] LabBatch tracedBatch(const LabSetup& setup, const MicroTracer& tracer, std::size_t cell,
                                   std::uint64_t batch);

/// Cells that cannot be measured any further, and why. No file keeps them: the next run tries again.
using LabFailures = std::map<std::size_t, std::string>;

/// Takes one more batch for each of these cells, unless it fails; false where it was stopped before the end.
using LabPass =
    std::function<bool(LabRun&, const std::vector<std::size_t>& cells, const std::function<bool()>& isStopped)>;

/// measure() with passes of any kind. Cells among `failures`, to which a pass may add, are left as they are.
void measureInPasses(LabRun& run, const LabPass& pass, const LabFailures& failures, const LabTargets& targets,
                     Progress* progress, const LabWatch& watch);

} // namespace reflectance
