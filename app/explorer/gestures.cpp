#include "app/explorer/gestures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance::explorer {
namespace {

constexpr double nearestLight = 0.05, farthestLight = 100.0;
constexpr double brightest = 1e6;

constexpr double largestSphere = 1.25;
/// Of the picture's half height or width: what is left is for the handle's disc.
constexpr double shareOfPicture = 0.95;
constexpr double roomForHandles = 1.12;

/// Tangent of half the vertical field of view.
double halfHeight(const Camera& camera)
{
    return std::tan(camera.fieldOfView * std::numbers::pi / 360.0);
}

Vec3d directionOf(const Light& light)
{
    return normalized(light.kind == LightKind::Directional ? light.direction : light.position);
}

/// A point light keeps its distance, a handle at the centre a little of one.
double distanceOf(const Light& light)
{
    return std::max(length(light.position), nearestLight);
}

/// The light in a unit direction.
Light turnedTo(Light light, const Vec3d& direction)
{
    if (light.kind == LightKind::Directional)
        light.direction = direction;
    else
        light.position = distanceOf(light) * direction;
    return light;
}

/// Turned about a unit axis (Rodrigues).
Vec3d turned(const Vec3d& v, const Vec3d& axis, double radians)
{
    const double c = std::cos(radians);
    return c * v + std::sin(radians) * cross(axis, v) + (1.0 - c) * dot(axis, v) * axis;
}

/// The ray `angle` radians off the unit direction `axis`, in the plane of `axis` and `ray`.
Vec3d tilted(const Vec3d& axis, const Vec3d& ray, double angle)
{
    const Vec3d side = normalized(ray - dot(ray, axis) * axis);
    return std::cos(angle) * axis + std::sin(angle) * side;
}

/// Where a unit ray from `eye` meets a sphere about the origin; a ray that misses touches it.
Vec3d pointOnSphere(const Vec3d& eye, const Vec3d& ray, double radius, bool farHalf)
{
    const double along = -dot(eye, ray);
    const Vec3d nearest = eye + along * ray;
    const double half = std::sqrt(std::max(0.0, radius * radius - dot(nearest, nearest)));
    return nearest + (farHalf ? half : -half) * ray;
}

} // namespace

HandleSphere handleSphere(const Light& light, const Camera& camera, ViewSize size)
{
    if (light.kind == LightKind::Point)
        return {{}, distanceOf(light)};
    const double aspect = static_cast<double>(size.width) / size.height;
    const double tangent = shareOfPicture * halfHeight(camera) * std::min(1.0, aspect);
    const double fits = length(camera.eye - camera.target) * std::sin(std::atan(tangent));
    return {camera.target, std::min(largestSphere, fits)};
}

Vec3d handlePoint(const Light& light, const Camera& camera, ViewSize size)
{
    if (light.kind == LightKind::Point)
        return light.position;
    const HandleSphere sphere = handleSphere(light, camera, size);
    return sphere.centre + sphere.radius * directionOf(light);
}

HandleView viewOf(const Light& light, const Camera& camera, ViewSize size)
{
    const Vec3d point = handlePoint(light, camera, size);
    const Vec3d image = projected(camera, point, size.width, size.height);
    // The far half of a sphere is where its normal turns away from the eye.
    return {image.x, image.y, image.z > 0.0, dot(directionOf(light), camera.eye - point) < 0.0};
}

int handleAt(std::span<const Light> lights, const Camera& camera, ViewSize size, Cursor cursor, double reach)
{
    int best = -1;
    double bestRank = 0.0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const HandleView handle = viewOf(lights[i], camera, size);
        const double distance = std::hypot(handle.x - cursor.x, handle.y - cursor.y);
        if (!handle.visible || !(distance <= reach))
            continue;
        const double rank = distance + (handle.behind ? 2.0 * reach : 0.0);
        if (best < 0 || rank < bestRank) {
            best = static_cast<int>(i);
            bestRank = rank;
        }
    }
    return best;
}

Light heldAt(const Light& light, bool farHalf, const Camera& camera, ViewSize size, Cursor cursor)
{
    const HandleSphere sphere = handleSphere(light, camera, size);
    const Vec3d eye = camera.eye - sphere.centre;
    const double distance = length(eye);
    Vec3d ray = rayThrough(camera, cursor.x, cursor.y, size.width, size.height);
    if (distance <= sphere.radius) // the eye is inside: only the far half is in front of it
        return turnedTo(light, normalized(pointOnSphere(eye, ray, sphere.radius, true)));

    const Vec3d inward = -(eye / distance);
    const double silhouette = std::asin(sphere.radius / distance);
    const double angle = std::atan2(length(cross(inward, ray)), dot(inward, ray));
    if (angle > silhouette) {
        ray = tilted(inward, ray, std::max(0.0, 2.0 * silhouette - angle));
        farHalf = !farHalf;
    }
    return turnedTo(light, normalized(pointOnSphere(eye, ray, sphere.radius, farHalf)));
}

Light rolled(const Light& light, const Camera& camera, ViewSize size, double dx, double dy)
{
    const double radius = handleSphere(Light(), camera, size).radius;
    const double distance = length(camera.eye - camera.target);
    const double pixelsPerRadian = 0.5 * size.height * radius / (halfHeight(camera) * distance);
    const double angle = std::hypot(dx, dy) / pixelsPerRadian;
    if (!(angle > 0.0))
        return light;
    const CameraFrame frame = frameOf(camera);
    const Vec3d axis = normalized(dx * frame.up + dy * frame.right);
    const Vec3d direction = directionOf(light);
    return turnedTo(light, normalized(turned(direction == Vec3d() ? frame.back : direction, axis, angle)));
}

Light reached(const Light& light, double dy)
{
    const double factor = std::exp2(-dy / 100.0);
    Light result = light;
    if (light.kind == LightKind::Point) {
        const Vec3d direction = directionOf(light);
        result.position = std::clamp(distanceOf(light) / factor, nearestLight, farthestLight) *
                          (direction == Vec3d() ? Vec3d(0.0, 1.0, 0.0) : direction);
    } else {
        const double largest = std::max({light.intensity.x, light.intensity.y, light.intensity.z});
        result.intensity = light.intensity * (largest > 0.0 ? std::min(factor, brightest / largest) : 1.0);
    }
    return result;
}

Camera orbitedByDrag(const Camera& camera, ViewSize size, double dx, double dy)
{
    const double perPixel = std::numbers::pi / size.height;
    return orbited(camera, -dx * perPixel, dy * perPixel);
}

Camera pannedByDrag(const Camera& camera, ViewSize size, double dx, double dy)
{
    return panned(camera, dx / size.height, dy / size.height);
}

Camera framedWithHandles(const Camera& camera, ViewSize size)
{
    return zoomed(framed(camera, static_cast<double>(size.width) / size.height), roomForHandles);
}

Camera zoomedByWheel(const Camera& camera, double steps)
{
    return zoomed(camera, std::exp2(-steps / 6.0));
}

Camera zoomedByDrag(const Camera& camera, double dy)
{
    return zoomed(camera, std::exp2(dy / 200.0));
}

Stroke strokeFrom(MouseButton button, Modifiers modifiers, Cursor cursor, int handle, int selected,
                  std::span<const Light> lights, const Camera& camera, ViewSize size)
{
    Stroke stroke;
    stroke.start = cursor;
    stroke.cameraBefore = camera;
    const bool anywhere = modifiers.control && modifiers.shift;
    if (anywhere && selected >= 0 && button != MouseButton::Middle) {
        stroke.kind = button == MouseButton::Left ? Stroke::Kind::RollLight : Stroke::Kind::ReachLight;
        stroke.light = selected;
    } else if (button == MouseButton::Left && handle >= 0) {
        stroke.kind = Stroke::Kind::HoldLight;
        stroke.light = handle;
        const HandleView view = viewOf(lights[static_cast<std::size_t>(handle)], camera, size);
        stroke.grip = {view.x - cursor.x, view.y - cursor.y};
        stroke.farHalf = view.behind;
    } else if (button == MouseButton::Middle || (button == MouseButton::Left && modifiers.shift)) {
        stroke.kind = Stroke::Kind::Pan;
    } else if (button == MouseButton::Left) {
        stroke.kind = Stroke::Kind::Orbit;
    } else {
        stroke.kind = Stroke::Kind::Zoom;
    }
    if (stroke.light >= 0)
        stroke.lightBefore = lights[static_cast<std::size_t>(stroke.light)];
    return stroke;
}

Camera cameraOf(const Stroke& stroke, ViewSize size, Cursor cursor)
{
    const double dx = cursor.x - stroke.start.x, dy = cursor.y - stroke.start.y;
    if (stroke.kind == Stroke::Kind::Orbit)
        return orbitedByDrag(stroke.cameraBefore, size, dx, dy);
    if (stroke.kind == Stroke::Kind::Pan)
        return pannedByDrag(stroke.cameraBefore, size, dx, dy);
    if (stroke.kind == Stroke::Kind::Zoom)
        return zoomedByDrag(stroke.cameraBefore, dy);
    return stroke.cameraBefore;
}

Light lightOf(const Stroke& stroke, ViewSize size, Cursor cursor)
{
    const double dx = cursor.x - stroke.start.x, dy = cursor.y - stroke.start.y;
    if (dx == 0.0 && dy == 0.0)
        return stroke.lightBefore; // a click selects; it must not change the last bit of a direction
    switch (stroke.kind) {
    case Stroke::Kind::HoldLight:
        return heldAt(stroke.lightBefore, stroke.farHalf, stroke.cameraBefore, size,
                      {cursor.x + stroke.grip.x, cursor.y + stroke.grip.y});
    case Stroke::Kind::RollLight:
        return rolled(stroke.lightBefore, stroke.cameraBefore, size, dx, dy);
    case Stroke::Kind::ReachLight:
        return reached(stroke.lightBefore, dy);
    default:
        return stroke.lightBefore;
    }
}

} // namespace reflectance::explorer
