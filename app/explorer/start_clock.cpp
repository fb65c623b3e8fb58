#include "app/explorer/start_clock.h"

#include "core/base/text.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string_view>
#include <unistd.h>

namespace reflectance::explorer {
namespace {

constexpr std::string_view last = "shown";

/// How long this process has been running; 0 where the system does not tell. See proc(5): field 22 of stat.
double processSeconds()
{
#ifdef __linux__
    std::ifstream file("/proc/self/stat");
    std::string text;
    std::getline(file, text);
    const std::size_t name = text.rfind(')'); // the name may hold spaces
    if (name == std::string::npos)
        return 0.0;
    std::istringstream fields(text.substr(name + 1));
    std::string skipped;
    for (int field = 3; field < 22; ++field)
        fields >> skipped;
    double ticks = 0.0;
    timespec now{};
    if (!(fields >> ticks) || clock_gettime(CLOCK_BOOTTIME, &now) != 0)
        return 0.0;
    const double since = ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
    return std::max(0.0, static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - since);
#else
    return 0.0;
#endif
}

std::string milliseconds(double seconds)
{
    return std::to_string(static_cast<long>(1e3 * seconds + 0.5));
}

} // namespace

StartClock::StartClock()
    : start_(Clock::now() -
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(processSeconds())))
{
}

void StartClock::note(const char* stage)
{
    if (!done())
        stages_.emplace_back(stage, std::chrono::duration<double>(Clock::now() - start_).count());
}

bool StartClock::done() const
{
    return !stages_.empty() && stages_.back().first == last;
}

std::string StartClock::sentence() const
{
    return done() ? "First picture after " + general(stages_.back().second, 2) + " s." : std::string();
}

std::string StartClock::report() const
{
    std::string text = sentence() + "\n";
    double before = 0.0;
    for (const auto& [stage, end] : stages_) {
        text += "  " + milliseconds(end - before) + " ms  " + stage + "\n";
        before = end;
    }
    return text;
}

} // namespace reflectance::explorer
