// What a value must be: a number, not negative, and 0 where no light arrives.
#include "core/study/properties/measures.h"

#include <limits>

namespace reflectance::properties {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

template <class Look> void everyPrecision(const Place& place, const Look& look)
{
    for (const Precision precision : corePrecisions) {
        Place here = place;
        here.precision = precision;
        look(here);
    }
}

template <class Look> void atLegalEnds(const Model& model, const std::vector<Directions>& directions, const Look& look)
{
    for (const auto& values : legalEnds(model.text))
        for (const Directions& d : directions)
            everyPrecision({values, d}, look);
}

} // namespace

Finding measureFiniteness(const Model& model, const Effort& effort)
{
    const auto directions = directionSamples(effort.directions);
    Finding finding;
    const auto look = [&](const Place& here) {
        finding.see(std::isfinite(largestOf(valueAt(model, here))) ? 0.0 : infinite, here);
    };
    everywhere(model, effort, directions, [&](const Place& place) { everyPrecision(place, look); });
    atLegalEnds(model, directions, look);
    return finding;
}

Finding measureNegativity(const Model& model, const Effort& effort)
{
    constexpr Vec3d primaries[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Finding finding;
    everywhere(model, effort, directionSamples(effort.directions), [&](const Place& place) {
        everyPrecision(place, [&](const Place& here) {
            for (const Vec3d& I : primaries)
                finding.see(-smallestOf(valueAt(model, here, I)), here);
        });
    });
    return finding;
}

Finding measureUnlit(const Model& model, const Effort& effort)
{
    const auto directions = unlitSamples(effort.directions / 4);
    Finding finding;
    const auto look = [&](const Place& here) { finding.see(largestOf(valueAt(model, here)), here); };
    everywhere(model, effort, directions, [&](const Place& place) { everyPrecision(place, look); });
    atLegalEnds(model, directions, look);
    return finding;
}

} // namespace reflectance::properties
