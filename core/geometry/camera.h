// A pinhole camera, and its rays. Both renderers take their rays and matrices from here.
#pragma once

#include "core/math/vec.h"

#include <glm/mat4x4.hpp>

namespace reflectance {

/// Meshes fill the unit sphere about the origin, so the default sees any of them whole.
struct Camera {
    Vec3d eye{1.7, 1.1, 2.6};
    Vec3d target{0.0, 0.0, 0.0};
    Vec3d up{0.0, 1.0, 0.0};
    double fieldOfView = 35.0; ///< vertical, degrees, 1 .. 120

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Right, up and backward axes (orthonormal); robust where up is parallel to the view.
struct CameraFrame {
    Vec3d right, up, back;
};
[[nodiscard]] CameraFrame frameOf(const Camera& camera);

/// Unit direction from the eye through the image point (x, y) in pixels, (0, 0) the upper left corner.
[[nodiscard]] Vec3d rayThrough(const Camera& camera, double x, double y, int width, int height);

[[nodiscard]] glm::dmat4 viewFromWorld(const Camera& camera);

/// Near and far planes enclose the sphere about the origin of the given radius (hazard H60).
[[nodiscard]] glm::dmat4 clipFromView(const Camera& camera, double aspect, double sceneRadius = 1.0);

/// Image point in pixels of a world point, with its depth along the view (negative behind the eye) in z.
[[nodiscard]] Vec3d projected(const Camera& camera, const Vec3d& world, int width, int height);

/// Turned about the target by radians: yaw about `up`, pitch about the right axis, kept 0.5 degrees short of the poles.
[[nodiscard]] Camera orbited(const Camera& camera, double yaw, double pitch);
/// Moved with its target by image fractions of the picture's height, as a hand drags the object.
[[nodiscard]] Camera panned(const Camera& camera, double dx, double dy);
/// Distance to the target multiplied by factor, kept within 0.05 .. 1000.
[[nodiscard]] Camera zoomed(const Camera& camera, double factor);
/// Same direction, looking at the origin from where the unit sphere fills the picture.
[[nodiscard]] Camera framed(const Camera& camera, double aspect);

} // namespace reflectance
