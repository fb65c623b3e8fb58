// The hands of several ranks, as the first of them sees them: its own and those of the others.
#pragma once

#include "core/study/crew/local_crew.h"
#include "core/study/crew/rank_link.h"
#include "core/study/crew/rank_message.h"

#include <chrono>
#include <memory>

namespace reflectance {

/// How long a rank may be silent, which says every second that it lives, before it is given up. One that comes back is
/// welcome. On the same host a death is seen at once.
struct RankPatience {
    std::chrono::milliseconds withOthers{30000}; ///< of the first rank
    std::chrono::milliseconds withFirst{300000}; ///< of the others, who have nobody else
};

class RankCrew : public Crew {
public:
    /// `own` may be null where the first rank only hands out.
    RankCrew(std::unique_ptr<RankLink> link, std::unique_ptr<LocalCrew> own, const RankPatience& patience = {});
    /// Tells the others to end.
    ~RankCrew() override;

    void give(std::size_t hand, std::string_view job) override;
    [[nodiscard]] std::vector<CrewEvent> wait(std::chrono::milliseconds longest) override;

private:
    using Clock = std::chrono::steady_clock;
    struct Peer {
        Clock::time_point heard;
        long process = 0; ///< where it runs on this host, else 0
        std::size_t firstHand = 0, hands = 0;
        bool isLost = false;
    };
    struct Remote {
        int rank = 0;
        std::size_t hand = 0;     ///< of that rank
        std::uint64_t serial = 0; ///< of its job; 0: idle
    };

    [[nodiscard]] std::size_t ownHands() const { return own_ ? own_->size() : 0; }
    void hear(int from, const RankMessage& message, std::vector<CrewEvent>& events);
    void welcome(int from, const RankMessage& hello);
    void comesBack(Peer& peer, std::vector<CrewEvent>& events);
    void keepInTouch(std::vector<CrewEvent>& events);
    [[nodiscard]] bool isDead(const Peer& peer, Clock::time_point now) const;

    std::unique_ptr<RankLink> link_;
    std::unique_ptr<LocalCrew> own_;
    RankPatience patience_;
    std::vector<Peer> peers_; ///< by rank
    std::vector<Remote> remotes_;
    std::uint64_t serials_ = 0;
    Clock::time_point spoke_;
};

/// What every rank but the first does: works for it until it says that all is done. The Error says that nothing is heard of it
/// any more.
[[nodiscard]] Result<void> workForFirstRank(RankLink& link, std::unique_ptr<LocalCrew> own,
                                            const RankPatience& patience = {});

} // namespace reflectance
