// Puts a crew together: of this machine, or of all ranks that mpirun started.
#pragma once

#include "core/base/result.h"
#include "core/study/crew/crew.h"

#include <functional>

namespace reflectance {

/// Calls `lead` with a crew of `hands` processes in this rank (as handsFor counts them) and those of the other ranks. In a rank
/// that is not the first, `lead` is not called: it works until the first is done. To be called once, and before other threads
/// hold what the work needs, for it forks. The Error is that of `lead`, or says why there is no crew.
[[nodiscard]] Result<void> withCrew(unsigned hands, const CrewWork& work,
                                    const std::function<Result<void>(Crew&)>& lead);

} // namespace reflectance
