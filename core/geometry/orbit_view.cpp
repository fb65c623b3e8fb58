#include "core/geometry/orbit_view.h"

#include <cmath>
#include <numbers>

namespace reflectance {

Camera orbitView(Camera camera, double azimuth, double elevation, double aspect)
{
    const double a = azimuth * std::numbers::pi / 180.0;
    const double e = elevation * std::numbers::pi / 180.0;
    camera.target = {};
    camera.eye = {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
    return framed(camera, aspect);
}

} // namespace reflectance
