#include "core/study/crew/local_crew.h"

#include "core/base/check.h"

#include <poll.h>

namespace reflectance {

Result<std::unique_ptr<LocalCrew>> LocalCrew::create(unsigned hands, const CrewWork& work)
{
    std::unique_ptr<LocalCrew> crew(new LocalCrew);
    for (unsigned i = 0; i < hands; ++i) {
        auto process = HandProcess::start(work);
        if (!process && i == 0)
            return process.error();
        if (!process)
            break; // fewer do it as well
        crew->hands_.push_back({*std::move(process)});
        crew->news_.push_back({CrewEvent::Kind::Ready, i});
    }
    return crew;
}

LocalCrew::~LocalCrew()
{
    for (Hand& hand : hands_) // all, before the first is waited for
        hand.process.dismiss();
}

void LocalCrew::give(std::size_t hand, std::string_view job)
{
    CHECK_EQ(hands_[hand].serial, 0U);
    hands_[hand].serial = ++serials_;
    hands_[hand].process.give(serials_, job);
}

bool LocalCrew::hear(Hand& hand, CrewEvent& event)
{
    HandMessage message = hand.process.hear();
    hand.isGone = message.kind == CrewEvent::Kind::Gone;
    if (!hand.isGone && message.serial != hand.serial)
        return false; // of a job whose worker died with its result already sent
    hand.serial = 0;
    event.kind = message.kind;
    event.text = std::move(message.text);
    return true;
}

std::vector<CrewEvent> LocalCrew::wait(std::chrono::milliseconds longest)
{
    if (!news_.empty())
        return std::exchange(news_, {});
    std::vector<pollfd> ears;
    for (const Hand& hand : hands_)
        ears.push_back({hand.isGone ? -1 : hand.process.descriptor(), POLLIN, 0});
    if (::poll(ears.data(), ears.size(), static_cast<int>(longest.count())) <= 0)
        return {};
    std::vector<CrewEvent> events;
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        CrewEvent event{CrewEvent::Kind::Ready, i};
        if (ears[i].revents != 0 && hear(hands_[i], event))
            events.push_back(std::move(event));
    }
    return events;
}

} // namespace reflectance
