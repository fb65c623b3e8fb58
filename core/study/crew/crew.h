// A crew: hands that take one job at a time, each in a process of its own, here or on other machines. A hand that dies loses
// nothing but its job.
#pragma once

#include "core/render/progress.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// What a hand does: the bytes of a job to the bytes of its result. It stays in its process and may remember things from job to
/// job. When `progress` is cancelled nobody waits for the result any more.
using CrewWork = std::function<std::string(std::string_view job, Progress& progress)>;

/// Bytes; no job and no result is longer. A message arrives whole or not at all.
inline constexpr std::size_t longestMessage = 131072;

struct CrewEvent {
    enum class Kind {
        Ready,    ///< a hand is there, and idle
        Finished, ///< with its job: `text` is the result; it is idle
        Died,     ///< of its job, and `text` says how; another has taken its place, idle
        Gone      ///< and its job with it, not known to be the job's fault: a machine went down
    };
    Kind kind = Kind::Ready;
    std::size_t hand = 0;
    std::string text = {};
};

class Crew {
public:
    Crew() = default;
    virtual ~Crew() = default; ///< stops what the hands still do
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// `hand` is idle.
    virtual void give(std::size_t hand, std::string_view job) = 0;

    /// What happened since, in order; waits for something to happen, but not longer than that.
    [[nodiscard]] virtual std::vector<CrewEvent> wait(std::chrono::milliseconds longest) = 0;
};

} // namespace reflectance
