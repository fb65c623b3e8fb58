// How a surface spreads one light at a probed point, as lines in the scene: the lobe.
#pragma once

#include "core/study/probe/probe.h"

#include <vector>

namespace reflectance {

/// A point of a line lies at P + radius (value / largest) omega, for a viewer in the unit direction omega.
struct LobeShape {
    std::vector<std::vector<Vec3d>> wires; ///< half circles through N and circles about it, every 30 and 15 degrees
    std::vector<Vec3d>
        inPlane; ///< of N and L, from beside R to beside L, half a degree above the horizon at both ends; every degree, finer about R
    double largest = 0.0; ///< of the factor, mean of its channels, for white light; 0: nothing is drawn
};

/// Of `probe.lights[light]`. What is below 0, or no number, is drawn as 0. `radius` is in the scene's units.
[[nodiscard]] LobeShape lobeShape(const Scene& scene, const Probe& probe, std::size_t light, double radius);

} // namespace reflectance
