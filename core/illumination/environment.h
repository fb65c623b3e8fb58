// The light that surrounds the object: nothing, one colour everywhere, a small studio, or a latitude-longitude picture.
// Today only the mirror looks at it; the status line says when a model does not.
#pragma once

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/math/vec.h"

#include <memory>
#include <string>

namespace reflectance {

enum class EnvironmentKind { None, Constant, Studio, Map };

struct Environment {
    EnvironmentKind kind = EnvironmentKind::Studio;
    Vec3d radiance{1.0, 1.0, 1.0};    ///< Constant: its colour. Studio and Map: a factor per channel
    double rotation = 0.0;            ///< degrees about the y axis
    std::string file;                 ///< Map: where it was loaded from
    std::shared_ptr<const Image> map; ///< Map: latitude-longitude; top row = up (+y), centre column = -z

    friend bool operator==(const Environment&, const Environment&) = default;
};

/// Radiance that arrives from a unit direction (pointing away from the object).
[[nodiscard]] Vec3d radianceFrom(const Environment& environment, const Vec3d& direction);
[[nodiscard]] Vec3f radianceFrom(const Environment& environment, const Vec3f& direction);

/// Reads a latitude-longitude picture (.exr or .hdr).
[[nodiscard]] Result<Environment> loadEnvironment(const std::string& path);

} // namespace reflectance
