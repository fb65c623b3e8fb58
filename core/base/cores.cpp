#include "core/base/cores.h"

#include <algorithm>
#include <sched.h>
#include <thread>

namespace reflectance {

unsigned usableCores()
{
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
        return static_cast<unsigned>(std::max(1, CPU_COUNT(&allowed)));
    return std::max(1U, std::thread::hardware_concurrency());
}

} // namespace reflectance
