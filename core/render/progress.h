// Lets another thread watch long work and stop it.
#pragma once

#include <atomic>

namespace reflectance {

struct Progress {
    std::atomic<double> done{0.0}; ///< 0 .. 1
    std::atomic<bool> cancel{false};
};

} // namespace reflectance
