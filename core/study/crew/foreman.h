// The foreman hands jobs to whoever is idle and takes their results over in the order of the jobs.
#pragma once

#include "core/base/result.h"
#include "core/study/crew/crew.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace reflectance {

struct JobOutcome {
    std::string result;
    std::string failure = {}; ///< why there is no result; empty: there is one
};

/// Jobs `first` .. `end` - 1.
struct JobList {
    std::uint64_t first = 0, end = 0;
    std::function<std::string(std::uint64_t)> text; ///< what a hand is told
    /// Called in the order of the jobs. An Error stops all.
    std::function<Result<void>(std::uint64_t, const JobOutcome&)> take;
};

class Foreman {
public:
    /// How far the fastest may be ahead of the slowest, in jobs per hand: what a kill can lose, and what waits in memory.
    static constexpr std::uint64_t lead = 8;
    /// A job of which so many hands are gone is blamed for it and fails.
    static constexpr int mostLost = 2;

    explicit Foreman(Crew& crew) : crew_(&crew) {}

    /// Runs through a list; true when all is done, false when `isStopped` said so. Then the foreman is of no further use, for
    /// hands are still at work.
    [[nodiscard]] Result<bool> run(const JobList& jobs, const std::function<bool()>& isStopped = {});

private:
    void handOut(const JobList& jobs);
    [[nodiscard]] Result<void> hear(const JobList& jobs, const CrewEvent& event);
    [[nodiscard]] Result<void> finish(const JobList& jobs, std::uint64_t job, JobOutcome outcome);

    Crew* crew_;
    std::set<std::size_t> hands_, idle_;
    std::map<std::size_t, std::uint64_t> working_; ///< hand to job
    std::deque<std::uint64_t> again_;              ///< jobs whose hands are gone
    std::map<std::uint64_t, int> lost_;            ///< how often
    std::map<std::uint64_t, JobOutcome> waiting_;  ///< for their turn
    std::uint64_t next_ = 0, taken_ = 0;
    bool hadHands_ = false;
};

} // namespace reflectance
