// How many machine instructions a piece of work takes: a figure that a busy machine does not disturb.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace reflectance {

/// Instructions that this thread spends on the work, outside the kernel; nothing where the system does not let a program
/// count them (Linux: perf_event_paranoid above 2, most containers and virtual machines); the work then may not run.
[[nodiscard]] std::optional<std::uint64_t> instructionsOf(const std::function<void()>& work);

} // namespace reflectance
