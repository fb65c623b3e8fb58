// How many threads this process renders and traces with.
#pragma once

#include <memory>

namespace reflectance {

/// While it lives, no more than `threads` (at least 1) share the process's loops, Embree's included: where several processes
/// share a machine, each would otherwise take all of it. What is computed does not depend on it.
class ThreadLimit {
public:
    explicit ThreadLimit(unsigned threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

} // namespace reflectance
