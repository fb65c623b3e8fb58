#include "core/study/bench/interleaved.h"

namespace reflectance {

std::vector<Timing> interleaved(std::span<const TimedWork> works, int repetitions, double units, Progress& progress,
                                double share)
{
    std::vector<std::vector<double>> times(works.size());
    const double part = share / (static_cast<double>(works.size()) * (repetitions + 1));
    for (int round = 0; round <= repetitions; ++round)
        for (std::size_t i = 0; i < works.size() && !progress.cancel; ++i) {
            const double spent = works[i]() / units;
            if (round > 0)
                times[i].push_back(spent);
            progress.done.fetch_add(part);
        }
    std::vector<Timing> timings;
    for (std::vector<double>& list : times)
        timings.push_back(timingOf(std::move(list)));
    return timings;
}

} // namespace reflectance
