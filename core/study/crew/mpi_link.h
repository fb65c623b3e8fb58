// Messages between ranks by Open MPI.
#pragma once

#include "core/base/result.h"
#include "core/study/crew/rank_link.h"

#include <memory>

namespace reflectance {

struct MpiRank {
    std::unique_ptr<RankLink> link;
    int rank = 0; ///< of this process
};

/// Opens the library and meets the other ranks, for which it waits. Refused, in one sentence: a program that was built without
/// MPI, a machine without the library. Once a process, and by the thread that then uses the link.
[[nodiscard]] Result<MpiRank> openMpi();

} // namespace reflectance
