// A passive surface sends on no more light than arrives.
#include "core/base/text.h"
#include "core/study/properties/albedo.h"
#include "core/study/properties/measures.h"

#include <algorithm>

namespace reflectance::properties {
namespace {

/// Degrees. Towards grazing light a factor without the cosine grows without bound.
constexpr double angles[] = {0, 15, 30, 45, 60, 70, 80, 85, 88, 89, 89.5, 89.9};

Directions lightAt(double angle)
{
    const double a = angle * 0.017453292519943295;
    return {{0, 0, 1}, {-std::sin(a), 0, std::cos(a)}, {}};
}

using Quantity = Share (HemisphereSums::*)(const Model&, std::span<const double>);

Finding largestShare(const Model& model, const Effort& effort, Quantity quantity, bool ofLight)
{
    Finding finding;
    double error = 0.0;
    const auto samples = parameterSamples(model.text, effort.parameterSets);
    for (const double angle : angles) {
        HemisphereSums sums(angle);
        Directions directions = lightAt(angle);
        if (!ofLight)
            std::swap(directions.L, directions.V);
        for (const auto& values : samples) {
            const Share share = (sums.*quantity)(model, values);
            finding.see(std::max({share.value.x, share.value.y, share.value.z}), {values, directions});
            error = std::max(error, share.error / std::max(1.0, largestOf(share.value)));
        }
    }
    finding.note = "two quadratures agree to " + general(error, 1);
    return finding;
}

} // namespace

Finding measureAlbedo(const Model& model, const Effort& effort)
{
    return largestShare(model, effort, &HemisphereSums::albedo, true);
}

Finding measureFurnace(const Model& model, const Effort& effort)
{
    return largestShare(model, effort, &HemisphereSums::furnace, false);
}

} // namespace reflectance::properties
