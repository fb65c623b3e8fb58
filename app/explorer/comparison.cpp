#include "app/explorer/comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reflectance::explorer {
namespace {

/// The clay of the lecture's photograph: reddish, as rough as Oren and Nayar measured theirs (40 degrees).
const std::vector<double> clayAlbedo{0.69, 0.43, 0.29};
constexpr double clayRoughness = 0.7;

/// From a little above and beside the viewer: where rough clay looks flat.
Light lampBesideTheCamera(const Camera& camera)
{
    const Vec3d V = normalized(camera.eye - camera.target);
    const Vec3d right = normalized(cross(camera.up, V));
    Light lamp;
    lamp.name = "key";
    lamp.direction = normalized(V - 0.16 * right + 0.16 * cross(V, right));
    lamp.angularRadius = 4.0;
    return lamp;
}

void showClay(CompareView& compare, Scene& scene)
{
    compare.beforeClay = BeforeClay{scene.surface, scene.other, scene.lights, scene.camera, compare.on, compare.mode};
    Surface lambert = scene.surface;
    lambert.model = "lambert_color";
    lambert.convention = Convention::Sensor;
    lambert.values["K"] = {clayAlbedo[0], 0, 0, 0, clayAlbedo[1], 0, 0, 0, clayAlbedo[2]};
    Surface rough = scene.surface;
    rough.model = "oren_nayar";
    rough.convention = Convention::Sensor;
    rough.values["rho"] = clayAlbedo;
    rough.values["sigma"] = {clayRoughness};
    scene.surface = std::move(lambert);
    scene.other = std::move(rough);
    scene.lights = {lampBesideTheCamera(scene.camera)};
    compare.on = true;
    compare.mode = CompareMode::SideBySide;
    compare.handOnB = false;
}

void putClayAway(CompareView& compare, Scene& scene)
{
    BeforeClay before = std::move(*compare.beforeClay);
    compare.beforeClay.reset();
    scene.surface = std::move(before.surface);
    scene.other = std::move(before.other);
    scene.lights = std::move(before.lights);
    scene.camera = before.camera;
    compare.on = before.comparing;
    compare.mode = before.mode;
    compare.handOnB = false;
}

} // namespace

Panes panesOf(const CompareView& compare, const Area& area, float scale)
{
    if (!compare.on || compare.mode != CompareMode::SideBySide)
        return {area, area};
    const float gap = 2.0F * scale;
    const float width = std::max(1.0F, std::floor(0.5F * (area.width - gap)));
    return {{area.x, area.y, width, area.height}, {area.right() - width, area.y, width, area.height}};
}

void toggleCompare(CompareView& compare, Scene& scene)
{
    compare.on = !compare.on;
    compare.handOnB = compare.handOnB && compare.on;
    if (compare.on && !scene.other)
        scene.other = scene.surface;
}

Surface& surfaceInHand(const CompareView& compare, Scene& scene)
{
    return compare.on && compare.handOnB && scene.other ? *scene.other : scene.surface;
}

const Surface& surfaceInHand(const CompareView& compare, const Scene& scene)
{
    return compare.on && compare.handOnB && scene.other ? *scene.other : scene.surface;
}

void swapVariants(Scene& scene)
{
    if (scene.other)
        std::swap(scene.surface, *scene.other);
}

void toggleClay(CompareView& compare, Scene& scene)
{
    if (compare.beforeClay)
        putClayAway(compare, scene);
    else
        showClay(compare, scene);
}

} // namespace reflectance::explorer
