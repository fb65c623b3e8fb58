#include "core/study/cost/timing.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace reflectance {
namespace {

/// The number at a share of the sorted list, between its neighbours.
double quantile(const std::vector<double>& sorted, double share)
{
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

} // namespace

Timing timingOf(std::vector<double> milliseconds)
{
    if (milliseconds.empty())
        return {};
    std::sort(milliseconds.begin(), milliseconds.end());
    return {quantile(milliseconds, 0.5), (quantile(milliseconds, 0.75) - quantile(milliseconds, 0.25)) / 2.0,
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
    return timingOf(std::move(times));
}

} // namespace reflectance
