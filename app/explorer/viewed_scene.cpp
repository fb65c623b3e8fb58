#include "app/explorer/viewed_scene.h"

#include "core/math/angle.h"
#include "core/scene/only_term.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {
namespace {

/// Of half the picture's height, at the point's distance.
constexpr double lobeShare = 0.42;
/// Pixels within which a click means a pin.
constexpr double pinReach = 12.0;

FoundProbe foundAt(const ExplorerState& state, const Scene& viewed, const ProbedPoint& point)
{
    FoundProbe found{probeAt(viewed, point), {}, {}, {}};
    if (state.compare.on && viewed.other)
        found.b = probeAt(variantB(viewed), point);
    return found;
}

std::optional<LobeShape> lobeOf(const Scene& scene, const Probe& probe, std::size_t light)
{
    if (probe.lights.empty())
        return std::nullopt;
    const double radius = lobeShare * std::tan(radians(0.5 * scene.camera.fieldOfView)) * probe.distance;
    return lobeShape(scene, probe, std::min(light, probe.lights.size() - 1), radius);
}

} // namespace

Scene viewedScene(const ExplorerState& state)
{
    Scene shown = shownScene(state);
    if (state.probe.term.empty())
        return shown;
    Result<Scene> alone = onlyTerm(shown, state.probe.term);
    return alone ? *std::move(alone) : shown;
}

bool seesTermAlone(const ExplorerState& state)
{
    const std::string& term = state.probe.term;
    if (term.empty())
        return false;
    const std::vector<std::string> known = termsAlone(state.scene);
    return std::ranges::find(known, term) != known.end();
}

std::string wordsFor(const std::string& term)
{
    if (term == "offdiagonal")
        return "off-diagonal K";
    return term.starts_with("term") ? term : term + " term";
}

void probeUnder(ExplorerState& state, Cursor cursor, ViewSize size)
{
    if (const auto pin = pinAt(state.scene, size, cursor, pinReach))
        return state.probe.pick(*pin);
    // The pixel's middle, where its one sample lies while the picture is coarse.
    state.probe.probe(placeAt(state.scene, {std::floor(cursor.x) + 0.5, std::floor(cursor.y) + 0.5}, size));
}

void examine(ExplorerState& state, const Scene& viewed, ViewSize picture)
{
    ProbeStudy& study = state.probe;
    const auto foundOf = [&](const std::optional<ProbedPoint>& point) {
        return point ? std::optional(foundAt(state, viewed, *point)) : std::nullopt;
    };
    if (study.picked && *study.picked >= viewed.pins.size()) // undo has taken it away
        study.picked.reset();
    study.foundPins.clear();
    for (const Pin& pin : viewed.pins)
        study.foundPins.push_back(foundOf(pointIn(pin, viewed, picture)));
    const bool there = study.loose && study.loose->mesh.lock() == viewed.mesh;
    study.foundLoose = there ? foundOf(pointIn(*study.loose, viewed.camera, picture)) : std::nullopt;
    study.lobeA.reset();
    study.lobeB.reset();
    const FoundProbe* found = study.found();
    if (!found || !study.lobe)
        return;
    study.lobeA = lobeOf(viewed, found->a, study.light);
    if (found->b)
        study.lobeB = lobeOf(variantB(viewed), *found->b, study.light);
}

} // namespace reflectance::explorer
