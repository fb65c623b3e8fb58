// Light adds up: two lights, twice the light, and the three colours of a light.
#include "core/reflectance/evaluate.h"
#include "core/study/properties/measures.h"

namespace reflectance::properties {
namespace {

constexpr Vec3d someLight{0.75, 0.3, 0.9};

/// Below this a product may be subnormal and lose digits.
double smallestSafe(Precision precision)
{
    return precision == Precision::Double ? 0x1p-1000 : 0x1p-100;
}

/// The largest relative difference of a channel; those that are too small to keep their digits are left out.
double relative(const Vec3d& got, const Vec3d& expected, Precision precision)
{
    const auto channel = [precision](double a, double b) {
        return std::fabs(b) < smallestSafe(precision) ? 0.0 : std::fabs(a - b) / std::fabs(b);
    };
    return largestOf({channel(got.x, expected.x), channel(got.y, expected.y), channel(got.z, expected.z)});
}

/// The sum in the precision that the kernels add in.
Vec3d sumIn(Precision precision, const Vec3d& a, const Vec3d& b)
{
    return precision == Precision::Double ? a + b : Vec3d(Vec3f(a) + Vec3f(b));
}

template <class Look> Finding everyPrecision(const Model& model, const Effort& effort, const Look& look)
{
    Finding finding;
    everywhere(model, effort, directionSamples(effort.directions), [&](Place place) {
        for (const Precision precision : corePrecisions) {
            place.precision = precision;
            finding.see(look(place), place);
        }
    });
    return finding;
}

} // namespace

Finding measureSuperposition(const Model& model, const Effort& effort)
{
    return everyPrecision(model, effort, [&](const Place& place) {
        const Directions& d = place.directions;
        Place other = place;
        other.directions.L = d.N; // a second light straight above
        const Observation both{d.N, d.V, {{d.L, Vec3d(1.0), discRadius}, {d.N, someLight, discRadius}}};
        const Vec3d got = evaluate(model, place.values, {&both, 1}, place.precision).front();
        const Vec3d expected = sumIn(place.precision, valueAt(model, place), valueAt(model, other, someLight));
        return relative(got, expected, place.precision);
    });
}

Finding measureScaling(const Model& model, const Effort& effort)
{
    return everyPrecision(model, effort, [&](const Place& place) {
        const Vec3d once = valueAt(model, place, someLight);
        double worst = 0.0;
        for (const double power : {0.125, 2.0, 1024.0})
            worst = std::fmax(worst, relative(valueAt(model, place, power * someLight), power * once, place.precision));
        return worst;
    });
}

Finding measureColours(const Model& model, const Effort& effort)
{
    return everyPrecision(model, effort, [&](const Place& place) {
        const Vec3d r = valueAt(model, place, {someLight.x, 0, 0});
        const Vec3d g = valueAt(model, place, {0, someLight.y, 0});
        const Vec3d b = valueAt(model, place, {0, 0, someLight.z});
        const double scale = largestOf(r) + largestOf(g) + largestOf(b);
        const double difference = largestOf(valueAt(model, place, someLight) - (r + g + b));
        return difference / (8.0 * unitRoundoff(place.precision) * std::fmax(scale, smallestSafe(place.precision)));
    });
}

} // namespace reflectance::properties
