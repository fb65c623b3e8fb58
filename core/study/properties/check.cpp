#include "core/study/properties/check.h"

#include "core/study/properties/measures.h"

#include <algorithm>

namespace reflectance::properties {
namespace {

/// Who says whether the property holds: physics for every model, or the model's text.
enum class Promise { EveryModel, Nonnegative, Reciprocal, Passive, FurnaceIfPassive };

struct Property {
    PropertyText text;
    Finding (*measure)(const Model&, const Effort&);
    Promise promise;
};

constexpr Property allProperties[] = {
    {{"values", "finite numbers", "double, float and SIMD; also at the ends of the legal ranges", 0.0, "exact"},
     measureFiniteness,
     Promise::EveryModel},
    {{"sign", "never negative for lights of one primary", "double, float and SIMD", 0.0, "exact"},
     measureNegativity,
     Promise::Nonnegative},
    {{"horizon", "exactly 0 where N.L <= 0",
      "double, float and SIMD; on the horizon, 1e-15 below it and deep; also at the ends of the legal ranges", 0.0,
      "exact: a gate"},
     measureUnlit,
     Promise::EveryModel},
    {{"superposition", "two lights give the sum of each, to the last bit", "double, float and SIMD", 0.0,
      "exact: one addition"},
     measureSuperposition,
     Promise::EveryModel},
    {{"scaling", "I times 1/8, 2 and 1024 scales the value, to the last bit", "double, float and SIMD", 0.0,
      "exact: powers of two"},
     measureScaling,
     Promise::EveryModel},
    {{"colours", "a light gives the sum of its primaries", "double, float and SIMD, in units of 8 eps of the parts",
      1.0, "a few roundings in K I"},
     measureColours,
     Promise::EveryModel},
    {{"rotation", "turning N, L and V together changes nothing",
      "double, float and SIMD, in units of 8 (kappa + 1) eps; kappa, the sensitivity to N, L and V, by differences",
      2.0, "turning rounds the inputs, and the value follows them by kappa; twice, for sums whose terms cancel"},
     measureRotation,
     Promise::EveryModel},
    {{"reciprocity", "f(L,V) = f(V,L) for f = factor / (pi N.L)", "relative difference, double", 1e-9,
      "rounding of the inputs, amplified by up to 1 / cos = 1e3 and by sqrt(1400 n) in the sharpest highlight, 1.2e5"},
     measureReciprocity,
     Promise::Reciprocal},
    {{"passivity", "the directional albedo never exceeds 1", "quadrature over V, lights at 0 to 89.9 degrees, double",
      1.0 + 1e-6, "the error of the quadrature"},
     measureAlbedo,
     Promise::Passive},
    {{"furnace", "surrounded by radiance 1, the surface is nowhere brighter",
      "quadrature over L, viewers at 0 to 89.9 degrees, double", 1.0 + 1e-6, "the error of the quadrature"},
     measureFurnace,
     Promise::FurnaceIfPassive},
    {{"limits", "the model becomes the ones that its text names", "double, float and SIMD, in units in the last place",
      2.0, "terms may be added in another order"},
     measureLimits,
     Promise::EveryModel},
};

const DeclaredProperty* declaration(const ModelText& model, Promise promise)
{
    if (promise == Promise::EveryModel)
        return nullptr;
    if (promise == Promise::Nonnegative)
        return &model.nonnegative;
    return promise == Promise::Reciprocal ? &model.reciprocal : &model.passive;
}

Verdict verdictOf(bool holds, const DeclaredProperty* declared, Promise promise)
{
    if (!declared || declared->holds)
        return holds ? Verdict::Holds : Verdict::Broken;
    if (promise == Promise::FurnaceIfPassive)
        return Verdict::Reported;
    return holds ? Verdict::Broken : Verdict::ExpectedFailure;
}

} // namespace

std::string_view nameOf(Verdict verdict)
{
    constexpr std::string_view names[] = {"holds", "expected failure", "reported", "BROKEN"};
    return names[static_cast<int>(verdict)];
}

std::vector<PropertyResult> checkModel(const Model& model, const Effort& effort)
{
    std::vector<PropertyResult> results;
    for (const Property& property : allProperties) {
        Finding finding = property.measure(model, effort);
        if (!finding.applies)
            continue;
        const bool holds = finding.worst <= property.text.allowed;
        const DeclaredProperty* declared = declaration(model.text, property.promise);
        const Verdict verdict = verdictOf(holds, declared, property.promise);
        results.push_back({property.text, std::move(finding), holds, declared ? declared->reason : "", verdict});
    }
    return results;
}

bool asDeclared(const std::vector<PropertyResult>& results)
{
    return std::none_of(results.begin(), results.end(),
                        [](const PropertyResult& result) { return result.verdict == Verdict::Broken; });
}

} // namespace reflectance::properties
