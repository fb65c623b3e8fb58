#include "app/cli/long_work.h"

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <unistd.h>

namespace reflectance::cli {
namespace {

/// A signal handler reaches nothing but globals.
Progress theProgress;

void onInterrupt(int /*signal*/)
{
    theProgress.cancel = true;
}

/// Work shorter than this shows nothing.
constexpr std::chrono::milliseconds patience{300};

void showUntilStopped(const std::stop_token& stop)
{
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    bool shown = false;
    while (!wake.wait_for(lock, stop, patience, [&stop] { return stop.stop_requested(); })) {
        std::fprintf(stderr, "\r%3.0f %%", 100.0 * theProgress.done);
        shown = true;
    }
    if (shown)
        std::fputs("\r     \r", stderr);
}

} // namespace

LongWork::LongWork()
{
    theProgress.done = 0.0;
    theProgress.cancel = false;
    std::signal(SIGINT, onInterrupt);
    if (isatty(STDERR_FILENO) != 0)
        display_ = std::jthread(showUntilStopped);
}

LongWork::~LongWork()
{
    display_ = {}; // stops and joins before the terminal is used again
    std::signal(SIGINT, SIG_DFL);
}

Progress& LongWork::progress()
{
    return theProgress;
}

bool LongWork::wasStopped()
{
    return theProgress.cancel;
}

} // namespace reflectance::cli
