// What a hand does in the picture, as pure functions: mouse positions, camera and light in, camera and light out.
// Positions are pixels of the picture, (0, 0) its upper left corner, as in core/geometry/camera.h.
#pragma once

#include "core/geometry/camera.h"
#include "core/illumination/light.h"
#include "core/study/grab/grasp.h"

#include <span>

namespace reflectance::explorer {

/// Size of the picture in pixels.
struct ViewSize {
    int width = 1;
    int height = 1;

    friend bool operator==(const ViewSize&, const ViewSize&) = default;
};

struct Cursor {
    double x = 0.0;
    double y = 0.0;
};

/// The sphere on which a light's handle moves. A directional light has no place, only a direction, so its sphere may
/// lie where the hand can reach it: about the camera's target, of radius 1.25 (the object's own is 1) or as large as
/// fits into the picture. A point light's sphere lies about the object's centre, through the light.
struct HandleSphere {
    Vec3d centre;
    double radius = 1.25;
};
[[nodiscard]] HandleSphere handleSphere(const Light& light, const Camera& camera, ViewSize size);

/// Where a light is held.
[[nodiscard]] Vec3d handlePoint(const Light& light, const Camera& camera, ViewSize size);

/// How a handle lies in the picture.
struct HandleView {
    double x = 0.0, y = 0.0;
    bool visible = false; ///< in front of the eye
    bool behind = false;  ///< on the far half of its sphere, seen from the eye
};
[[nodiscard]] HandleView viewOf(const Light& light, const Camera& camera, ViewSize size);

/// The light whose handle lies within `reach` pixels of the cursor: the nearest one, near halves before far halves.
/// -1 where there is none.
[[nodiscard]] int handleAt(std::span<const Light> lights, const Camera& camera, ViewSize size, Cursor cursor,
                           double reach);

/// The light with its handle moved under the cursor, on the sphere that the handle lies on. Beyond the sphere's
/// silhouette it rolls over the edge to the other half, as far inside as the cursor is outside, so the way out and the
/// way back are the same. `farHalf` says which half the handle was taken from.
[[nodiscard]] Light heldAt(const Light& light, bool farHalf, const Camera& camera, ViewSize size, Cursor cursor);

/// Rolls the sphere of directions under the hand, wherever the hand is (Ctrl+Shift+drag, as in MeshLab): a stroke of
/// the sphere's own radius on the screen turns the light by one radian.
[[nodiscard]] Light rolled(const Light& light, const Camera& camera, ViewSize size, double dx, double dy);

/// Ctrl+Shift+right-drag: 100 pixels up bring a point light to half its distance, or double the intensity of a
/// directional light, which has no distance. Distances stay within 0.05 .. 100, intensities below 1e6.
[[nodiscard]] Light reached(const Light& light, double dy);

/// The camera after a left-drag: half a turn for a stroke of the picture's height.
[[nodiscard]] Camera orbitedByDrag(const Camera& camera, ViewSize size, double dx, double dy);
/// The camera after a middle-drag: what lies at the target's distance follows the hand.
[[nodiscard]] Camera pannedByDrag(const Camera& camera, ViewSize size, double dx, double dy);
/// The object whole, with room around it for the handles.
[[nodiscard]] Camera framedWithHandles(const Camera& camera, ViewSize size);
/// The camera after turns of the wheel; positive goes nearer.
[[nodiscard]] Camera zoomedByWheel(const Camera& camera, double steps);
/// The camera after a right-drag: 200 pixels up halve the distance to the target.
[[nodiscard]] Camera zoomedByDrag(const Camera& camera, double dy);

/// One stroke of the mouse, from press to release. Results follow from the start of the stroke, never from the steps
/// between, so moving back undoes it exactly.
struct Stroke {
    enum class Kind { None, Orbit, Pan, Zoom, HoldLight, RollLight, ReachLight, Grab };
    Kind kind = Kind::None;
    Cursor start;
    Cursor grip;          ///< HoldLight: from the cursor to the handle, so that it does not jump when taken
    bool farHalf = false; ///< HoldLight
    int light = -1;
    Camera cameraBefore;
    Light lightBefore;
    Grip taken = Grip::Spot;   ///< Grab (grab_tool.h): what is held
    double widthBefore = 0.0;  ///< Grab: the number that says how wide a highlight is, of a model that has one
    double heightBefore = 0.0; ///< Grab: of the highlight where the stroke began, of its peak

    [[nodiscard]] bool movesCamera() const { return kind == Kind::Orbit || kind == Kind::Pan || kind == Kind::Zoom; }
    [[nodiscard]] bool movesLight() const { return kind != Kind::None && !movesCamera(); }
};

enum class MouseButton { Left, Right, Middle };

struct Modifiers {
    bool shift = false;
    bool control = false;
};

/// What the press of a button starts. `handle` is the light under the cursor, `selected` the selected one; -1: none.
[[nodiscard]] Stroke strokeFrom(MouseButton button, Modifiers modifiers, Cursor cursor, int handle, int selected,
                                std::span<const Light> lights, const Camera& camera, ViewSize size);

[[nodiscard]] Camera cameraOf(const Stroke& stroke, ViewSize size, Cursor cursor);
[[nodiscard]] Light lightOf(const Stroke& stroke, ViewSize size, Cursor cursor);

} // namespace reflectance::explorer
