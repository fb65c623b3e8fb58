// Counts what the process holds by new, at present and at most. Linking it replaces new and delete.
#pragma once

#include <cstddef>

namespace reflectance::fuzz {

/// Bytes held at most since the last restart.
[[nodiscard]] std::size_t peakMemory();

/// Forgets the peak; what is held now.
std::size_t restartPeak();

} // namespace reflectance::fuzz
