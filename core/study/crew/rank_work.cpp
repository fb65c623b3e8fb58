#include "core/study/crew/rank_crew.h"

#include <map>
#include <utility>

namespace reflectance {
namespace {

using Clock = std::chrono::steady_clock;
using Kind = RankMessage::Kind;

constexpr std::chrono::milliseconds pulse{2};
constexpr std::chrono::seconds betweenSigns{1};

class Helper {
public:
    Helper(RankLink& link, LocalCrew& own) : link_(link), own_(own), serials_(own.size(), 0)
    {
        link_.send(0, written(greeting(own_.size())));
    }

    /// Whether the first rank said that all is done, and how to part.
    std::optional<bool> listen()
    {
        while (const auto message = link_.receive()) {
            heard_ = Clock::now();
            const auto read = readRankMessage(message->text);
            if (read && read->kind == Kind::Hello)
                first_ = processHere(*read);
            if (read && read->kind == Kind::End)
                return read->hand == 1;
            if (read && read->kind == Kind::Job && read->hand < own_.size())
                take(*read);
        }
        return std::nullopt;
    }

    void report()
    {
        for (const CrewEvent& event : own_.wait(pulse)) {
            if (event.kind == CrewEvent::Kind::Ready)
                continue; // was said with the greeting
            const Kind kind = event.kind == CrewEvent::Kind::Finished ? Kind::Finished
                              : event.kind == CrewEvent::Kind::Died   ? Kind::Died
                                                                      : Kind::Gone;
            link_.send(0, written({kind, event.hand, std::exchange(serials_[event.hand], 0), event.text}));
            if (const auto next = waiting_.find(event.hand); kind != Kind::Gone && next != waiting_.end()) {
                give(next->second);
                waiting_.erase(next);
            }
        }
        if (Clock::now() - spoke_ >= betweenSigns) {
            link_.send(0, written({Kind::Alive}));
            spoke_ = Clock::now();
        }
        link_.flush();
    }

    [[nodiscard]] bool isAlone(Clock::duration patience) const
    {
        return isNoMore(first_) || Clock::now() - heard_ > patience;
    }

private:
    /// A rank that was given up and came back may be given work while it still does what others did since.
    void take(const RankMessage& job)
    {
        if (serials_[job.hand] == 0)
            give(job);
        else
            waiting_[job.hand] = job;
    }

    void give(const RankMessage& job)
    {
        serials_[job.hand] = job.serial;
        own_.give(job.hand, job.text);
    }

    RankLink& link_;
    LocalCrew& own_;
    std::vector<std::uint64_t> serials_; ///< of the jobs in hand; 0: none
    std::map<std::size_t, RankMessage> waiting_;
    long first_ = 0; ///< the process of the first rank, where it runs on this host
    Clock::time_point heard_ = Clock::now(), spoke_ = Clock::now();
};

} // namespace

Result<void> workForFirstRank(RankLink& link, std::unique_ptr<LocalCrew> own, const RankPatience& patience)
{
    Helper helper(link, *own);
    for (;;) {
        if (const auto isInOrder = helper.listen()) {
            own.reset();
            if (*isInOrder)
                link.finish();
            return {};
        }
        helper.report();
        if (helper.isAlone(patience.withFirst))
            return Error{
                "does not hear of the first of the ranks any more, and ends; the same command goes on where it was"};
    }
}

} // namespace reflectance
