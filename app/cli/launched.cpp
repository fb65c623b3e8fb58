#include "app/cli/launched.h"

#include "app/cli/verbs.h"
#include "core/study/crew/ranks.h"

#include <chrono>
#include <thread>

namespace reflectance::cli {

std::optional<int> refusedLaunch()
{
    const auto ranks = ranksHere();
    if (ranks)
        return std::nullopt;
    return isHelper() ? BadInput : refused(ranks.error());
}

int refusedHere(const Error& error, int exitCode)
{
    if (isHelper())
        std::this_thread::sleep_for(std::chrono::seconds(2));
    return refused(error, exitCode);
}

} // namespace reflectance::cli
