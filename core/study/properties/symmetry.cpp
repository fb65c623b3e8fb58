// What must not matter: which of two directions is the light, and how the whole is turned.
#include "core/math/lobe.h"
#include "core/study/properties/measures.h"

namespace reflectance::properties {
namespace {

/// Values below this come from the tail of a highlight, where subnormal numbers lose digits.
constexpr double smallestValue = 1e-290;

double largestDifference(const Vec3d& a, const Vec3d& b)
{
    const double scale = std::fmax(largestOf(a), largestOf(b));
    return scale < smallestValue ? 0.0 : largestOf(a - b) / scale;
}

/// How the value moves with its nine inputs, by differences: the sum of |df/dx| over the components of N, L and V.
Vec3d sensitivity(const Model& model, Place place, const Vec3d& value)
{
    constexpr double step = 0x1p-30; // its square and 2^-53 / step both stay below one part in 1e6
    place.precision = Precision::Double;
    Vec3d sum;
    for (Vec3d Directions::*vector : {&Directions::N, &Directions::L, &Directions::V})
        for (double Vec3d::*component : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
            Place moved = place;
            moved.directions.*vector.*component += step;
            const Vec3d difference = valueAt(model, moved) - value;
            sum += Vec3d(std::fabs(difference.x), std::fabs(difference.y), std::fabs(difference.z)) / step;
        }
    return sum;
}

Directions turned(const Directions& d, std::size_t which)
{
    constexpr Vec3d axes[][2] = {{{1, 2, -3}, {-2, 0.5, 1}}, {{0, 0, 1}, {1, 1, 0.3}}, {{3, -1, 2}, {0.2, 5, 1}}};
    const Vec3d first = normalized(axes[which % std::size(axes)][0]);
    const Vec3d second = normalized(axes[which % std::size(axes)][1]);
    // Two mirrors make a rotation.
    const auto turn = [&](const Vec3d& v) { return mirrored(second, mirrored(first, v)); };
    return {turn(d.N), turn(d.L), turn(d.V)};
}

} // namespace

Finding measureReciprocity(const Model& model, const Effort& effort)
{
    Finding finding;
    everywhere(model, effort, directionSamples(effort.directions), [&](const Place& place) {
        Place swapped = place;
        std::swap(swapped.directions.L, swapped.directions.V);
        // f(L,V) = factor(L,V) / (pi N.L); both sides times pi (N.L)(N.V). The disc of a light stands for a delta, whose
        // own cosine has cancelled the one in the factor.
        const Directions& d = place.directions;
        const double there = model.text.usesLightSize ? 1.0 : dot(d.N, d.V);
        const double back = model.text.usesLightSize ? 1.0 : dot(d.N, d.L);
        finding.see(largestDifference(there * valueAt(model, place), back * valueAt(model, swapped)), place);
    });
    return finding;
}

Finding measureRotation(const Model& model, const Effort& effort)
{
    Finding finding;
    std::size_t which = 0;
    everywhere(model, effort, directionSamples(effort.directions), [&](Place place) {
        const Vec3d exact = valueAt(model, place);
        const Vec3d moves = sensitivity(model, place, exact);
        for (const Precision precision : corePrecisions) {
            place.precision = precision;
            Place other = place;
            other.directions = turned(place.directions, which++);
            const Vec3d difference = valueAt(model, other) - valueAt(model, place);
            const double floor = precision == Precision::Double ? smallestValue : 0x1p-120;
            const auto units = [&](double got, double slope, double value) {
                return std::fabs(got) / (8.0 * unitRoundoff(precision) * (slope + std::fabs(value)) + floor);
            };
            finding.see(largestOf({units(difference.x, moves.x, exact.x), units(difference.y, moves.y, exact.y),
                                   units(difference.z, moves.z, exact.z)}),
                        place);
        }
    });
    return finding;
}

} // namespace reflectance::properties
