// The hands of this machine.
#pragma once

#include "core/study/crew/hand_process.h"

#include <memory>

namespace reflectance {

class LocalCrew : public Crew {
public:
    /// Forks `hands` (at least 1) processes; nothing that the caller's other threads hold may be needed by the work.
    [[nodiscard]] static Result<std::unique_ptr<LocalCrew>> create(unsigned hands, const CrewWork& work);
    ~LocalCrew() override;

    [[nodiscard]] std::size_t size() const { return hands_.size(); }
    void give(std::size_t hand, std::string_view job) override;
    [[nodiscard]] std::vector<CrewEvent> wait(std::chrono::milliseconds longest) override;

private:
    struct Hand {
        HandProcess process;
        std::uint64_t serial = 0; ///< of its job; 0: idle
        bool isGone = false;
    };

    LocalCrew() = default;
    [[nodiscard]] bool hear(Hand& hand, CrewEvent& event);

    std::vector<Hand> hands_;
    std::vector<CrewEvent> news_;
    std::uint64_t serials_ = 0;
};

} // namespace reflectance
