// On what a cost was measured: without it a time says nothing.
#pragma once

#include <string>

namespace reflectance {

struct Machine {
    std::string processor; ///< as the system names it; "unknown processor" where it does not
    unsigned cores = 1;    ///< that this process may use
    std::string lanes;     ///< the SIMD instruction set in use
    std::string compiler;
    std::string gl; ///< renderer and version; empty without one
};

/// `gl`: GlRenderer::description(), or "".
[[nodiscard]] Machine thisMachine(std::string gl = {});

/// "AMD EPYC 7763, 2 cores, avx2; GCC 12.2.0; llvmpipe ..., OpenGL 4.5".
[[nodiscard]] std::string sentenceOf(const Machine& machine);

} // namespace reflectance
