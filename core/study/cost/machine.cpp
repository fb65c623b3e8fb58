#include "core/study/cost/machine.h"

#include "core/base/text.h"
#include "core/reflectance/kernel_tables.h"

#include <algorithm>
#include <fstream>
#include <sched.h>
#include <thread>
#include <utility>

namespace reflectance {
namespace {

std::string processorName()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name"))
            return std::string(trimmed(std::string_view(line).substr(line.find(':') + 1)));
    return "unknown processor";
}

unsigned usableCores()
{
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
        return static_cast<unsigned>(std::max(1, CPU_COUNT(&allowed)));
    return std::max(1U, std::thread::hardware_concurrency());
}

std::string compilerName()
{
#if defined(__clang__)
    return "Clang " __clang_version__;
#elif defined(__GNUC__)
    return "GCC " __VERSION__;
#else
    return "unknown compiler";
#endif
}

} // namespace

Machine thisMachine(std::string gl)
{
    return {processorName(), usableCores(), lanesName(), compilerName(), std::move(gl)};
}

std::string sentenceOf(const Machine& machine)
{
    std::string text = machine.processor + ", " + std::to_string(machine.cores) +
                       (machine.cores == 1 ? " core, " : " cores, ") + machine.lanes + "; " + machine.compiler;
    return machine.gl.empty() ? text : text + "; " + machine.gl;
}

} // namespace reflectance
