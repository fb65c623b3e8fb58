// Two pieces of work measured turn about: a busy machine slows both, and their ratio stays.
#pragma once

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <vector>

namespace reflectance::bench {

template <class Work> double millisecondsOf(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

inline double median(std::vector<double>& times)
{
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

/// Runs both once to warm up, then in turn; reports medians in milliseconds and the ratio of the medians.
template <class Ours, class Yardstick>
void alternate(benchmark::State& state, const Ours& ours, const Yardstick& yardstick)
{
    std::vector<double> mine;
    std::vector<double> its;
    ours();
    yardstick();
    for (auto _ : state) {
        mine.push_back(millisecondsOf(ours));
        its.push_back(millisecondsOf(yardstick));
    }
    const double one = median(mine);
    const double other = median(its);
    state.counters["ours_ms"] = one;
    state.counters["yardstick_ms"] = other;
    state.counters["ratio"] = one / other;
}

} // namespace reflectance::bench
