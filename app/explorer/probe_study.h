// Probed points: where they lie on the object, what is known of them, and which part of the picture is looked at alone.
#pragma once

#include "app/explorer/gestures.h"
#include "core/image/image.h"
#include "core/study/lens/gl_check.h"
#include "core/study/probe/lobe_shape.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// A point of the object, as it was met. It stays there when the camera moves.
struct ProbePlace {
    std::weak_ptr<const Mesh> mesh;
    ProbedPoint point; ///< as it was met
    Camera camera;     ///< from where
};

/// Where a ray through the picture meets the object; nothing beside it.
[[nodiscard]] std::optional<ProbePlace> placeAt(const Scene& scene, Cursor cursor, ViewSize size);

/// The same point in a picture from elsewhere or of another size.
[[nodiscard]] ProbedPoint pointIn(const ProbePlace& place, const Camera& camera, ViewSize size);

/// A pin's point in the scene's picture; nothing where another object is shown.
[[nodiscard]] std::optional<ProbedPoint> pointIn(const Pin& pin, const Scene& scene, ViewSize size);

/// The pixel in which a point lies, of the picture at rest.
struct ProbedPixel {
    bool seen = false;            ///< the point is not hidden there
    std::optional<GlPixel> drawn; ///< GL and double on the samples that GL drew; none at the object's edge
};
/// `drawn` is GL's picture of `samples`. Nothing where the point lies outside.
[[nodiscard]] std::optional<ProbedPixel> pixelOf(const ViewSamples& samples, const Image& drawn, const Scene& scene,
                                                 const ProbedPoint& point);

/// What is known of a place: A's surface and, while two are compared, B's.
struct FoundProbe {
    Probe a;
    std::optional<Probe> b;
    std::optional<ProbedPixel> pixelA, pixelB; ///< none while the picture moves
};

enum class ProbeDetail { Point, Terms };

struct ProbeStudy {
    std::optional<ProbePlace> loose;   ///< probed last and not pinned
    std::optional<std::size_t> picked; ///< of the scene's pins; none: the loose one
    std::size_t light = 0;             ///< of those that shine: whose formula is filled in
    bool onB = false;                  ///< the formula shown is B's
    bool arrows = true, lobe = true;   ///< drawn over the picture
    ProbeDetail detail = ProbeDetail::Point;
    std::string term;   ///< seen alone, as onlyTerm has it; empty: the whole picture
    bool asked = false; ///< a key wants the point under the mouse, or in the middle

    // What the frame loop finds. Places of another mesh have none.
    std::uint64_t changes = 0; ///< of what is looked at
    std::vector<std::optional<FoundProbe>> foundPins;
    std::optional<FoundProbe> foundLoose;
    std::optional<LobeShape> lobeA, lobeB; ///< of the one that is looked at

    /// Whether a pin or the loose one is looked at, be its object shown or not.
    [[nodiscard]] bool looks(const Scene& scene) const;
    [[nodiscard]] const FoundProbe* found() const;

    void probe(std::optional<ProbePlace> place); ///< becomes the loose one and is looked at; none puts it away
    void pin(Scene& scene);                      ///< the loose one, where there is one and room for it
    void remove(Scene& scene);                   ///< what is looked at
    void pick(std::size_t pin);
};

/// The pin whose marker lies within `reach` pixels of the cursor.
[[nodiscard]] std::optional<std::size_t> pinAt(const Scene& scene, ViewSize size, Cursor cursor, double reach);

/// Every place that has been found, pins first, A before B; named "rim A", "rim B", or "rim" where nothing is
/// compared.
[[nodiscard]] std::vector<Probe> listed(const ProbeStudy& study, const Scene& scene);

/// What is copied of a place: A's text and B's.
[[nodiscard]] std::string textOf(const FoundProbe& found);

} // namespace reflectance::explorer
