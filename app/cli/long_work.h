// Long work on a terminal: shows how far it is, and stops cleanly on Ctrl-C.
#pragma once

#include "core/render/cpu/cpu_renderer.h"

#include <thread>

namespace reflectance::cli {

/// Exit code of work that Ctrl-C stopped, as shells expect it.
inline constexpr int Stopped = 130;

/// While it lives, Ctrl-C sets progress().cancel, and standard error, if it is a terminal, shows the share done.
/// One at a time.
class LongWork {
public:
    LongWork();
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    [[nodiscard]] static Progress& progress();
    [[nodiscard]] static bool wasStopped();

private:
    std::jthread display_;
};

} // namespace reflectance::cli
