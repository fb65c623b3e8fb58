// What the rungs that change K ask of a scene. Included by rungs/*.cpp only.
#pragma once

#include "core/scene/scene.h"

#include <algorithm>
#include <array>
#include <string>

namespace reflectance::rung {

using Rows = std::array<double, 9>;

inline Rows rowsOf(const Scene& scene)
{
    Rows K{};
    const Parameter& parameter = *modelOf(scene).text.find("K");
    std::copy_n(valuesOf(scene).begin() + static_cast<std::ptrdiff_t>(parameter.offset), 9, K.begin());
    return K;
}

/// The same picture with K and lights in the sensor convention.
inline void turnToSensorConvention(Scene& scene)
{
    if (scene.surface.convention == Convention::Sensor)
        return;
    const Rows K = rowsOf(scene);
    scene.lights = shiningLights(scene);
    scene.surface.convention = Convention::Sensor;
    scene.surface.values["K"].assign(K.begin(), K.end());
}

inline bool isDiagonal(const Rows& K)
{
    return K[1] == 0.0 && K[2] == 0.0 && K[3] == 0.0 && K[5] == 0.0 && K[6] == 0.0 && K[7] == 0.0;
}

/// Why a scene has no K to simplify; empty where it has.
inline std::string withoutK(const Scene& scene)
{
    const ModelText& text = modelOf(scene).text;
    const Parameter* K = text.find("K");
    return K && K->kind == ParameterKind::Matrix ? "" : text.name + " has no K";
}

} // namespace reflectance::rung
