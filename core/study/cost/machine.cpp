#include "core/study/cost/machine.h"

#include "core/base/cores.h"
#include "core/base/text.h"
#include "core/reflectance/kernel_tables.h"

#include <fstream>
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
