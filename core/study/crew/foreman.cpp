#include "core/study/crew/foreman.h"

namespace reflectance {

Result<bool> Foreman::run(const JobList& jobs, const std::function<bool()>& isStopped)
{
    next_ = taken_ = jobs.first;
    lost_.clear();
    while (taken_ < jobs.end) {
        if (isStopped && isStopped())
            return false;
        handOut(jobs);
        for (const CrewEvent& event : crew_->wait(std::chrono::milliseconds(100)))
            if (const auto heard = hear(jobs, event); !heard)
                return heard.error();
        if (hadHands_ && hands_.empty() && taken_ < jobs.end)
            return Error{"no process is left that could compute; is the machine out of memory or processes?"};
    }
    return true;
}

void Foreman::handOut(const JobList& jobs)
{
    while (!idle_.empty()) {
        std::uint64_t job = next_;
        if (!again_.empty()) {
            job = again_.front();
            again_.pop_front();
        } else if (next_ < jobs.end && next_ < taken_ + lead * hands_.size())
            ++next_;
        else
            return;
        const std::size_t hand = *idle_.begin();
        idle_.erase(idle_.begin());
        working_[hand] = job;
        crew_->give(hand, jobs.text(job));
    }
}

Result<void> Foreman::hear(const JobList& jobs, const CrewEvent& event)
{
    const auto at = working_.find(event.hand);
    const auto job = at == working_.end() ? std::nullopt : std::optional(at->second);
    if (job)
        working_.erase(at);
    if (event.kind == CrewEvent::Kind::Gone) {
        hands_.erase(event.hand);
        idle_.erase(event.hand);
        if (job && ++lost_[*job] < mostLost)
            again_.push_back(*job);
        else if (job)
            return finish(jobs, *job, {{}, "the process that computed it was lost, and so was another"});
        return {};
    }
    hands_.insert(event.hand);
    hadHands_ = true;
    idle_.insert(event.hand);
    if (!job)
        return {};
    return finish(jobs, *job,
                  event.kind == CrewEvent::Kind::Finished ? JobOutcome{event.text, {}} : JobOutcome{{}, event.text});
}

Result<void> Foreman::finish(const JobList& jobs, std::uint64_t job, JobOutcome outcome)
{
    waiting_.emplace(job, std::move(outcome));
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == taken_;
         first = waiting_.erase(first), ++taken_)
        if (const auto took = jobs.take(first->first, first->second); !took)
            return took;
    return {};
}

} // namespace reflectance
