#include "app/explorer/grab_tool.h"

#include "core/base/text.h"
#include "core/study/grab/grab.h"
#include "core/study/grab/width.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {
namespace {

/// The scene with the surface that the hand is on: what it does in the picture concerns that one.
Scene inHand(const CompareView& compare, const Scene& scene)
{
    Scene seen = scene;
    seen.surface = surfaceInHand(compare, scene);
    return seen;
}

std::optional<ProbedPoint> pointUnder(Cursor cursor, ViewSize size, const Scene& scene)
{
    return pointAt(scene.mesh, scene.camera, cursor.x, cursor.y, size.width, size.height);
}

bool isIn(std::size_t light, const Scene& scene)
{
    return light < scene.lights.size();
}

double widthIn(const Surface& surface, const SpotWidth& width)
{
    return valueOf(*width.parameter, surface.values).front();
}

Result<Light> movedLight(const Stroke& stroke, const ProbedPoint& point, const Scene& seen)
{
    return stroke.taken == Grip::Terminator ? withTerminatorAt(stroke.lightBefore, point)
                                            : withSpotAt(stroke.lightBefore, seen.camera.eye, point, spotKindOf(seen));
}

/// Where the stroke began everything is as it was, to the last bit: a click changes nothing.
void takeBack(const Stroke& stroke, const CompareView& compare, Scene& scene)
{
    const auto light = static_cast<std::size_t>(stroke.light);
    Surface& surface = surfaceInHand(compare, scene);
    const auto width = stroke.taken == Grip::Edge ? spotWidthOf(inHand(compare, scene)) : std::nullopt;
    if (width && widthIn(surface, *width) != stroke.widthBefore)
        surface.values[width->parameter->name] = {stroke.widthBefore};
    else if (stroke.taken != Grip::Edge && isIn(light, scene))
        scene.lights[light] = stroke.lightBefore;
}

} // namespace

std::optional<Grasp> graspUnder(Cursor cursor, double reach, ViewSize size, const CompareView& compare,
                                const Scene& scene, int selected, bool& isThere)
{
    const auto point = pointUnder(cursor, size, scene);
    isThere = point.has_value();
    if (!point)
        return std::nullopt;
    if (const auto grasp = graspAt(inHand(compare, scene), *point, reach))
        return grasp;
    if (selected < 0 || !isIn(static_cast<std::size_t>(selected), scene))
        return std::nullopt;
    return Grasp{Grip::Spot, static_cast<std::size_t>(selected), HUGE_VAL};
}

Stroke grabStroke(const Grasp& grasp, Cursor cursor, ViewSize size, const CompareView& compare, const Scene& scene)
{
    Stroke stroke;
    if (!isIn(grasp.light, scene))
        return stroke;
    stroke.kind = Stroke::Kind::Grab;
    stroke.taken = grasp.grip;
    stroke.start = cursor;
    stroke.cameraBefore = scene.camera;
    stroke.light = static_cast<int>(grasp.light);
    stroke.lightBefore = scene.lights[grasp.light];
    const Scene seen = inHand(compare, scene);
    if (const auto width = spotWidthOf(seen))
        stroke.widthBefore = widthIn(seen.surface, *width);
    if (const auto point = pointUnder(cursor, size, scene))
        stroke.heightBefore = spotHeight(seen, stroke.lightBefore, *point).value_or(0.0);
    return stroke;
}

Result<void> follow(const Stroke& stroke, ViewSize size, Cursor cursor, const CompareView& compare, Scene& scene)
{
    if (cursor.x == stroke.start.x && cursor.y == stroke.start.y) {
        takeBack(stroke, compare, scene);
        return {};
    }
    const auto light = static_cast<std::size_t>(stroke.light);
    const auto point = pointUnder(cursor, size, scene);
    if (!point || !isIn(light, scene))
        return Error{"the object is not under the cursor; go back onto it"};
    if (stroke.taken == Grip::Edge) {
        // From where the stroke began: what lies outside the slider's range stays within reach.
        Scene began = inHand(compare, scene);
        const auto width = spotWidthOf(began);
        if (!width || !(stroke.heightBefore > 0.0) || !(stroke.heightBefore < 1.0))
            return {};
        began.surface.values[width->parameter->name] = {stroke.widthBefore};
        surfaceInHand(compare, scene).values[width->parameter->name] = {
            widthWithHeightAt(began, *width, stroke.lightBefore, *point, stroke.heightBefore)};
        return {};
    }
    auto moved = movedLight(stroke, *point, inHand(compare, scene));
    if (!moved)
        return moved.error();
    scene.lights[light] = *std::move(moved);
    return {};
}

Result<void> nudgeSpot(GrabTool& tool, const CompareView& compare, Scene& scene, int selected, double dx, double dy)
{
    if (tool.view == ViewSize())
        return {}; // no picture has been seen yet
    const auto index = static_cast<std::size_t>(std::max(0, selected));
    if (!isIn(index, scene))
        return Error{"no light is selected; press 1 for the first"};
    Light& light = scene.lights[index];
    const Scene seen = inHand(compare, scene);
    Cursor from = tool.spot;
    if (tool.spotLight != light || tool.spotCamera != scene.camera) {
        const auto found = spotIn(seen, light, tool.view.width, tool.view.height);
        if (!found)
            return Error{"no highlight of " + light.name +
                         " is seen; with the tool Grab, a drag on the object brings it "
                         "there"};
        from = {found->x, found->y};
    }
    const Cursor to{from.x + dx, from.y + dy};
    const auto point = pointUnder(to, tool.view, scene);
    if (!point)
        return {}; // at the object's rim
    const auto moved = withSpotAt(light, scene.camera.eye, *point, spotKindOf(seen));
    if (!moved)
        return {};
    light = *moved;
    tool.spot = to;
    tool.spotLight = light;
    tool.spotCamera = scene.camera;
    return {};
}

void narrowSpot(const CompareView& compare, Scene& scene, double factor)
{
    const auto width = spotWidthOf(inHand(compare, scene));
    if (!width)
        return;
    Surface& surface = surfaceInHand(compare, scene);
    const Parameter& number = *width->parameter;
    const double before = widthIn(surface, *width);
    surface.values[number.name] = {std::clamp(width->widens ? before / factor : before * factor,
                                              std::min(number.sliderMin, before), std::max(number.sliderMax, before))};
}

std::string nameOf(const Grasp& grasp, const CompareView& compare, const Scene& scene)
{
    const std::string light = isIn(grasp.light, scene) ? scene.lights[grasp.light].name : "no light";
    const Scene seen = inHand(compare, scene);
    if (const auto width = grasp.grip == Grip::Edge ? spotWidthOf(seen) : std::nullopt)
        return "Edge of the highlight of " + light + ", " + width->parameter->name + " = " +
               general(widthIn(seen.surface, *width), 4);
    return (grasp.grip == Grip::Terminator ? "Terminator of " : "Highlight of ") + light;
}

} // namespace reflectance::explorer
