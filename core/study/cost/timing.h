// Repeated times of a piece of work: their middle, and how far they scatter.
#pragma once

#include <functional>
#include <vector>

namespace reflectance {

/// Of the repetitions of one piece of work. The machine disturbs upwards only, and seldom: the middle is what it costs.
struct Timing {
    double median = 0.0; ///< milliseconds
    double spread = 0.0; ///< half the distance between the quartiles: half of all repetitions lie about the median so
    int repetitions = 0;
};

[[nodiscard]] Timing timingOf(const std::vector<double>& milliseconds);

/// Milliseconds that the work takes once.
[[nodiscard]] double millisecondsOf(const std::function<void()>& work);

/// Does a piece of work once and says how many milliseconds it took, by whatever clock is right for it.
using TimedWork = std::function<double()>;

[[nodiscard]] TimedWork byTheWall(std::function<void()> work);

/// The work alone: once to warm caches and threads up, then `repetitions` times.
[[nodiscard]] Timing timed(int repetitions, const TimedWork& work);

} // namespace reflectance
