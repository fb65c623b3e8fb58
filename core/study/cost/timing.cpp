#include "core/study/cost/timing.h"

#include "core/math/quantile.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace reflectance {
Timing timingOf(const std::vector<double>& milliseconds)
{
    if (milliseconds.empty())
        return {};
    return {medianOf(milliseconds), (quantileOf(milliseconds, 0.75) - quantileOf(milliseconds, 0.25)) / 2.0,
            static_cast<int>(milliseconds.size())};
}

double millisecondsOf(const std::function<void()>& work)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

TimedWork byTheWall(std::function<void()> work)
{
    return [work = std::move(work)] { return millisecondsOf(work); };
}

Timing timed(int repetitions, const TimedWork& work)
{
    static_cast<void>(work());
    std::vector<double> times;
    for (int i = 0; i < std::max(1, repetitions); ++i)
        times.push_back(work());
    return timingOf(times);
}

} // namespace reflectance
