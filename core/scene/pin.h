// A point of the object that a scene keeps under a name, for the probe.
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <string>

namespace reflectance {

struct Pin {
    std::string name;     ///< of its own within a scene
    std::string meshFile; ///< of the object that it lies on, as Scene::meshFile
    Vec3d P;              ///< scene units
    std::uint32_t triangle = 0;

    friend bool operator==(const Pin&, const Pin&) = default;
};

/// A scene keeps no more of them.
inline constexpr std::size_t mostPins = 20;

} // namespace reflectance
