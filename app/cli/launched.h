// Verbs that mpirun may start several times at once: one of the ranks speaks to the user.
#pragma once

#include "core/base/result.h"

#include <optional>

namespace reflectance::cli {

/// The exit code, where ranks cannot work together: said once.
[[nodiscard]] std::optional<int> refusedLaunch();

/// As refused(); in a rank that is not the first only after a while, when the first would have ended all of them had it met the
/// same.
[[nodiscard]] int refusedHere(const Error& error, int exitCode);

} // namespace reflectance::cli
