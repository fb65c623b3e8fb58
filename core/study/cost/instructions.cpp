#include "core/study/cost/instructions.h"

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace reflectance {
namespace {

/// The kernel's counter of this thread's instructions, closed when it goes.
class Counter {
public:
    Counter()
    {
        perf_event_attr wanted{};
        wanted.type = PERF_TYPE_HARDWARE;
        wanted.size = sizeof wanted;
        wanted.config = PERF_COUNT_HW_INSTRUCTIONS;
        wanted.disabled = 1;
        wanted.exclude_kernel = 1;
        wanted.exclude_hv = 1;
        file_ = static_cast<int>(syscall(SYS_perf_event_open, &wanted, 0, -1, -1, 0));
    }
    ~Counter()
    {
        if (file_ >= 0)
            close(file_);
    }
    Counter(const Counter&) = delete;
    Counter& operator=(const Counter&) = delete;

    [[nodiscard]] bool opened() const { return file_ >= 0; }
    void start() const
    {
        ioctl(file_, PERF_EVENT_IOC_RESET, 0);
        ioctl(file_, PERF_EVENT_IOC_ENABLE, 0);
    }
    [[nodiscard]] std::optional<std::uint64_t> stop() const
    {
        ioctl(file_, PERF_EVENT_IOC_DISABLE, 0);
        std::uint64_t count = 0;
        if (read(file_, &count, sizeof count) != sizeof count || count == 0)
            return std::nullopt; // a counter that was never scheduled tells nothing
        return count;
    }

private:
    int file_ = -1;
};

} // namespace

std::optional<std::uint64_t> instructionsOf(const std::function<void()>& work)
{
    const Counter counter;
    if (!counter.opened())
        return std::nullopt;
    counter.start();
    work();
    return counter.stop();
}

} // namespace reflectance
