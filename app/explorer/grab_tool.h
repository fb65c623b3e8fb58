// The tool Grab: the hand takes a highlight, its edge or a terminator in the picture, and the light or the number that
// says how wide a highlight is follows: n, alpha, m.
#pragma once

#include "app/explorer/comparison.h"
#include "app/explorer/gestures.h"
#include "core/study/grab/grasp.h"

#include <optional>
#include <string>

namespace reflectance::explorer {

struct GrabTool {
    bool on = false;
    ViewSize view;                ///< of the picture that the hand was last in
    std::optional<Grasp> hovered; ///< what the mouse would take
    bool overObject = false;      ///< the mouse is on the object
    std::string problem;          ///< why the stroke cannot go where the cursor is; empty where it can

    // Where the arrow keys have put a spot, as long as nothing else has moved it.
    Cursor spot;
    std::optional<Light> spotLight;
    Camera spotCamera;
};

/// What lies under the cursor: edge, spot or terminator within `reach` pixels, else, on the object, the spot of the
/// selected light, which a drag brings here. None beside the object, and where no light is selected.
[[nodiscard]] std::optional<Grasp> graspUnder(Cursor cursor, double reach, ViewSize size, const CompareView& compare,
                                              const Scene& scene, int selected, bool& isThere);

/// The stroke that a grasp starts; None where its light is not there.
[[nodiscard]] Stroke grabStroke(const Grasp& grasp, Cursor cursor, ViewSize size, const CompareView& compare,
                                const Scene& scene);

/// Brings what the stroke holds under the cursor. Where that cannot be, the scene stays and a sentence says why.
[[nodiscard]] Result<void> follow(const Stroke& stroke, ViewSize size, Cursor cursor, const CompareView& compare,
                                  Scene& scene);

/// One step of the arrow keys: the selected light's spot moves by so many pixels.
[[nodiscard]] Result<void> nudgeSpot(GrabTool& tool, const CompareView& compare, Scene& scene, int selected, double dx,
                                     double dy);

/// Makes the highlight of the surface in hand narrower by a factor of its width's number (n times it, alpha divided by it), within
/// the slider's range; nothing for a model without such a number.
void narrowSpot(const CompareView& compare, Scene& scene, double factor);

/// "Highlight of key", for people.
[[nodiscard]] std::string nameOf(const Grasp& grasp, const CompareView& compare, const Scene& scene);

} // namespace reflectance::explorer
