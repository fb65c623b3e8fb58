// The extremes, tried hazard by hazard between frames: GLSL's rows ask the window's own driver, so they run on its thread.
#pragma once

#include "core/study/extremes/extremes.h"

#include <string>
#include <vector>

namespace reflectance::explorer {

struct ExtremesStudy {
    std::vector<Finding> findings;
    std::vector<std::string> ids; ///< of all hazards, in their order; empty before the first run
    std::size_t tried = 0;        ///< how many of them
    bool running = false;

    void start();
    [[nodiscard]] float done() const; ///< 0 .. 1

    /// Tries the next hazard; the last one ends the run.
    void step(const Instruments& instruments);
};

} // namespace reflectance::explorer
