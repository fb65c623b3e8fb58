// One row of `eval`: a surface point with its viewer and its lights, given as directions.
#pragma once

#include "core/math/vec.h"

#include <vector>

namespace reflectance {

struct ObservedLight {
    Vec3d L;             ///< to the light, any length
    Vec3d I;             ///< as it arrives
    double radius = 0.0; ///< angular radius, degrees; serves the mirror
};

struct Observation {
    Vec3d N, V; ///< any length
    std::vector<ObservedLight> lights;
};

} // namespace reflectance
