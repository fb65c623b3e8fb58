#include "core/geometry/camera.h"

#include "core/math/angle.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

double halfHeight(const Camera& camera)
{
    return std::tan(radians(camera.fieldOfView) / 2.0);
}

double distanceOf(const Camera& camera)
{
    return length(camera.eye - camera.target);
}

} // namespace

CameraFrame frameOf(const Camera& camera)
{
    const Vec3d back = normalized(camera.eye - camera.target);
    Vec3d right = normalized(cross(camera.up, back));
    if (right == Vec3d())
        right = normalized(cross(std::fabs(back.x) < 0.9 ? Vec3d(1, 0, 0) : Vec3d(0, 0, 1), back));
    return {right, cross(back, right), back};
}

Vec3d rayThrough(const Camera& camera, double x, double y, int width, int height)
{
    const CameraFrame frame = frameOf(camera);
    const double scale = 2.0 * halfHeight(camera) / height;
    const double across = (x - 0.5 * width) * scale;
    const double above = (0.5 * height - y) * scale;
    return normalized(across * frame.right + above * frame.up - frame.back);
}

glm::dmat4 viewFromWorld(const Camera& camera)
{
    const CameraFrame f = frameOf(camera);
    const Vec3d t{-dot(f.right, camera.eye), -dot(f.up, camera.eye), -dot(f.back, camera.eye)};
    return {f.right.x, f.up.x, f.back.x, 0.0, f.right.y, f.up.y, f.back.y, 0.0,
            f.right.z, f.up.z, f.back.z, 0.0, t.x,       t.y,    t.z,      1.0};
}

glm::dmat4 clipFromView(const Camera& camera, double aspect, double sceneRadius)
{
    // The depth of the origin, not its distance: a panned camera does not look at it.
    const double depth = dot(camera.eye, frameOf(camera).back);
    const double far = std::max(depth + 1.01 * sceneRadius, 0.01 * sceneRadius);
    const double near = std::max(depth - 1.01 * sceneRadius, far * 1e-4);
    const double f = 1.0 / halfHeight(camera);
    glm::dmat4 m(0.0);
    m[0][0] = f / aspect;
    m[1][1] = f;
    m[2][2] = (far + near) / (near - far);
    m[2][3] = -1.0;
    m[3][2] = 2.0 * far * near / (near - far);
    return m;
}

Vec3d projected(const Camera& camera, const Vec3d& world, int width, int height)
{
    const CameraFrame f = frameOf(camera);
    const Vec3d d = world - camera.eye;
    const double depth = -dot(d, f.back);
    const double scale = 0.5 * height / (halfHeight(camera) * depth);
    return {0.5 * width + dot(d, f.right) * scale, 0.5 * height - dot(d, f.up) * scale, depth};
}

Camera orbited(const Camera& camera, double yaw, double pitch)
{
    const double limit = radians(89.5);
    const Vec3d up = normalized(camera.up);
    const Vec3d back = frameOf(camera).back;
    const double elevation = std::clamp(std::asin(std::clamp(dot(back, up), -1.0, 1.0)) + pitch, -limit, limit);
    const Vec3d right = frameOf(camera).right;
    const Vec3d level = cross(right, up);
    const Vec3d turned = std::cos(yaw) * level + std::sin(yaw) * right;
    Camera result = camera;
    result.eye = camera.target + distanceOf(camera) * (std::cos(elevation) * turned + std::sin(elevation) * up);
    return result;
}

Camera panned(const Camera& camera, double dx, double dy)
{
    const CameraFrame f = frameOf(camera);
    const double height = 2.0 * halfHeight(camera) * distanceOf(camera);
    const Vec3d shift = height * (dy * f.up - dx * f.right);
    Camera result = camera;
    result.eye += shift;
    result.target += shift;
    return result;
}

Camera zoomed(const Camera& camera, double factor)
{
    const double distance = std::clamp(distanceOf(camera) * factor, 0.05, 1000.0);
    Camera result = camera;
    result.eye = camera.target + distance * frameOf(camera).back;
    return result;
}

Camera framed(const Camera& camera, double aspect)
{
    const double vertical = radians(camera.fieldOfView) / 2.0;
    const double horizontal = std::atan(halfHeight(camera) * aspect);
    const double distance = 1.04 / std::sin(std::min(vertical, horizontal));
    Camera result = camera;
    result.target = {};
    result.eye = distance * frameOf(camera).back;
    return result;
}

} // namespace reflectance
