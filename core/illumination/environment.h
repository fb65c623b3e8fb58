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

/// Radiance that arrives from a unit direction (pointing away from the object); NaN for a direction with NaN.
///
/// A positive rotation turns the surroundings counterclockwise seen from above (+y): what stood at d stands at Ry d.
/// So the lookup goes along Ry^-1 d = (c x - s z, y, s x + c z), with c, s the cosine and sine of the rotation.
///
/// Map, W x H texels: longitude u = 1/2 + atan2(x, -z) / 2 pi (so +x lies right of the centre column -z, as one sees it
/// from inside), latitude v = atan2(sqrt(x^2 + z^2), y) / pi (0 at +y). Bilinear between texel centres at
/// x = W u - 1/2 (wrapping round) and y = H v - 1/2 (kept inside: above the first centre the top row alone counts).
/// shaders/illumination/map.glsl does the same.
[[nodiscard]] Vec3d radianceFrom(const Environment& environment, const Vec3d& direction);
[[nodiscard]] Vec3f radianceFrom(const Environment& environment, const Vec3f& direction);

/// Reads a latitude-longitude picture: OpenEXR or Radiance HDR, by content. Refuses formats that are not linear.
[[nodiscard]] Result<Environment> loadEnvironment(const std::string& path);

} // namespace reflectance
