// Whether this program was started once, or several times at once by mpirun or srun.
#pragma once

#include "core/base/result.h"

namespace reflectance {

struct Ranks {
    bool areMany = false;    ///< started through MPI, be it with one rank
    bool isFirst = true;     ///< it hands out the work, writes, and speaks to the user
    unsigned onThisHost = 1; ///< ranks that share its cores; 1 where nobody tells
};

/// From what the launcher wrote into the environment, without calling MPI. Refused: launchers that start the program several
/// times without Open MPI finding the others, so that all would write the same file.
[[nodiscard]] Result<Ranks> ranksHere();

/// Whether another rank writes, and speaks to the user; also where ranksHere() refuses.
[[nodiscard]] bool isHelper();

/// Processes to compute in, for this rank: `wanted`, or as many as there are cores for it where that is 0.
[[nodiscard]] unsigned handsFor(unsigned wanted);

/// Threads for each of so many processes.
[[nodiscard]] unsigned threadsPerHand(unsigned hands);

} // namespace reflectance
