// Short ways to ask a model for one row.
#pragma once

#include "core/reflectance/evaluate.h"
#include "tests/models/oracle.h"

#include <algorithm>
#include <cmath>

namespace reflectance::test {

inline constexpr Precision corePrecisions[] = {Precision::Double, Precision::Float, Precision::Simd};

[[nodiscard]] inline std::vector<std::string> allIds()
{
    std::vector<std::string> ids;
    for (const Model& model : catalogue())
        if (!model.text.usesTable) // black without a measurement; tests/measured and tests/render give it one
            ids.push_back(model.id());
    return ids;
}

[[nodiscard]] inline double unitRoundoff(Precision precision)
{
    return precision == Precision::Double ? 0x1p-53 : 0x1p-24;
}

[[nodiscard]] inline Vec3d evaluated(const std::string& model, const ParameterValues& parameters,
                                     const Observation& row, Precision precision)
{
    const Model& found = **findModel(model);
    return evaluate(found, flatValues(found.text, parameters), {&row, 1}, precision).front();
}

[[nodiscard]] inline Vec3d evaluated(const OracleCase& c, Precision precision)
{
    return evaluated(c.model, c.parameters, c.observation(), precision);
}

[[nodiscard]] inline double largestOf(const Vec3d& v)
{
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

} // namespace reflectance::test
