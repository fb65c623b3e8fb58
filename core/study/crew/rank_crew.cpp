#include "core/study/crew/rank_crew.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace reflectance {
namespace {

/// Between two looks at what other ranks say: of no weight beside a cell, and no load.
constexpr std::chrono::milliseconds pulse{2};
constexpr std::chrono::seconds betweenSigns{1};

} // namespace

RankCrew::RankCrew(std::unique_ptr<RankLink> link, std::unique_ptr<LocalCrew> own, const RankPatience& patience)
    : link_(std::move(link)), own_(std::move(own)), patience_(patience),
      peers_(static_cast<std::size_t>(link_->size()), Peer{Clock::now()}), spoke_(Clock::now())
{
    for (int rank = 1; rank < link_->size(); ++rank)
        link_->send(rank, written(greeting(ownHands())));
}

RankCrew::~RankCrew()
{
    own_.reset();
    const bool areAllHere = std::none_of(peers_.begin(), peers_.end(), [](const Peer& peer) { return peer.isLost; });
    for (int rank = 1; rank < link_->size(); ++rank)
        link_->send(rank, written({RankMessage::Kind::End, areAllHere ? 1U : 0U}));
    const auto latest = Clock::now() + std::chrono::seconds(5);
    while (!link_->flush() && Clock::now() < latest)
        std::this_thread::sleep_for(pulse);
    if (areAllHere)
        link_->finish();
}

void RankCrew::give(std::size_t hand, std::string_view job)
{
    if (hand < ownHands())
        return own_->give(hand, job);
    Remote& remote = remotes_[hand - ownHands()];
    remote.serial = ++serials_;
    link_->send(remote.rank, written({RankMessage::Kind::Job, remote.hand, remote.serial, std::string(job)}));
}

std::vector<CrewEvent> RankCrew::wait(std::chrono::milliseconds longest)
{
    const auto latest = Clock::now() + longest;
    std::vector<CrewEvent> events;
    do {
        if (own_)
            events = own_->wait(pulse);
        else
            std::this_thread::sleep_for(pulse);
        while (auto message = link_->receive())
            if (const auto read = readRankMessage(message->text))
                hear(message->from, *read, events);
        link_->flush();
        keepInTouch(events);
    } while (events.empty() && Clock::now() < latest);
    return events;
}

void RankCrew::hear(int from, const RankMessage& message, std::vector<CrewEvent>& events)
{
    using Kind = RankMessage::Kind;
    Peer& peer = peers_[static_cast<std::size_t>(from)];
    peer.heard = Clock::now();
    if (message.kind == Kind::Hello) {
        welcome(from, message);
        for (std::size_t i = 0; i < peer.hands; ++i)
            events.push_back({CrewEvent::Kind::Ready, ownHands() + peer.firstHand + i});
        return;
    }
    comesBack(peer, events);
    if (message.kind == Kind::Alive || message.hand >= peer.hands)
        return;
    Remote& remote = remotes_[peer.firstHand + message.hand];
    if (remote.serial != message.serial && message.kind != Kind::Gone)
        return; // of a job that others have done since
    remote.serial = 0;
    const CrewEvent::Kind kind = message.kind == Kind::Finished ? CrewEvent::Kind::Finished
                                 : message.kind == Kind::Died   ? CrewEvent::Kind::Died
                                                                : CrewEvent::Kind::Gone;
    events.push_back({kind, ownHands() + peer.firstHand + message.hand, message.text});
}

void RankCrew::welcome(int from, const RankMessage& hello)
{
    Peer& peer = peers_[static_cast<std::size_t>(from)];
    peer.firstHand = remotes_.size();
    peer.hands = hello.hand;
    peer.process = processHere(hello);
    for (std::size_t i = 0; i < hello.hand; ++i)
        remotes_.push_back({from, i});
}

/// A rank that was given up speaks again: what it had is done by others, so its hands are idle for us.
void RankCrew::comesBack(Peer& peer, std::vector<CrewEvent>& events)
{
    if (!std::exchange(peer.isLost, false))
        return;
    for (std::size_t i = 0; i < peer.hands; ++i)
        events.push_back({CrewEvent::Kind::Ready, ownHands() + peer.firstHand + i});
}

bool RankCrew::isDead(const Peer& peer, Clock::time_point now) const
{
    return isNoMore(peer.process) || now - peer.heard > patience_.withOthers;
}

void RankCrew::keepInTouch(std::vector<CrewEvent>& events)
{
    const auto now = Clock::now();
    for (std::size_t rank = 1; rank < peers_.size(); ++rank) {
        Peer& peer = peers_[rank];
        if (peer.isLost || !isDead(peer, now))
            continue;
        peer.isLost = true;
        for (std::size_t i = 0; i < peer.hands; ++i) {
            remotes_[peer.firstHand + i].serial = 0;
            events.push_back({CrewEvent::Kind::Gone, ownHands() + peer.firstHand + i});
        }
    }
    if (now - spoke_ < betweenSigns)
        return;
    spoke_ = now;
    for (std::size_t rank = 1; rank < peers_.size(); ++rank)
        if (!peers_[rank].isLost)
            link_->send(static_cast<int>(rank), written({RankMessage::Kind::Alive}));
}

} // namespace reflectance
