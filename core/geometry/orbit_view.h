// The view from a direction given by two angles, as flags and studies name it.
#pragma once

#include "core/geometry/camera.h"

namespace reflectance {

/// The camera moved to azimuth and elevation (degrees; 0, 0 looks along -z), looking at the origin from where the unit sphere
/// fills a picture of this width / height.
[[nodiscard]] Camera orbitView(Camera camera, double azimuth, double elevation, double aspect);

} // namespace reflectance
