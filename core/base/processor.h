// What the processor offers beyond what every x86-64 has.
#pragma once

namespace reflectance {

/// Whether code compiled with -mavx2 -mfma runs here. The same for the whole process.
[[nodiscard]] inline bool hasAvx2()
{
    static const bool has = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
    return has;
}

} // namespace reflectance
