// A hand as two processes: one works, the other keeps watch over it and starts it anew when it has died.
#pragma once

#include "core/base/result.h"
#include "core/study/crew/crew.h"

#include <cstdint>
#include <optional>
#include <sys/types.h>

namespace reflectance {

/// What the hand says; `serial` is that of the job.
struct HandMessage {
    CrewEvent::Kind kind = CrewEvent::Kind::Finished;
    std::uint64_t serial = 0;
    std::string text = {};
};

class HandProcess {
public:
    /// Forks, so no other thread may hold what the work needs. The processes ignore Ctrl-C, which is for their owner, and end
    /// with him.
    [[nodiscard]] static Result<HandProcess> start(const CrewWork& work);
    HandProcess(HandProcess&& other) noexcept;
    HandProcess& operator=(HandProcess&&) = delete;
    /// Tells the work to stop, waits for it a little, and then kills it.
    ~HandProcess();

    void give(std::uint64_t serial, std::string_view job) const;
    /// Readable when something is to be heard.
    [[nodiscard]] int descriptor() const { return socket_; }
    /// Of what is to be heard; Gone when the keeper itself has died.
    [[nodiscard]] HandMessage hear() const;
    /// To end; the destructor waits for it.
    void dismiss();

private:
    HandProcess(int socket, pid_t keeper) : socket_(socket), keeper_(keeper) {}

    int socket_ = -1;
    pid_t keeper_ = -1; ///< also of its process group
};

} // namespace reflectance
