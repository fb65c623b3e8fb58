// Surfaces for the tests of plots.
#pragma once

#include "core/study/curves.h"

namespace reflectance::test {

inline NamedSurface surfaceOf(const std::string& id, const ParameterValues& parameters)
{
    const Model& model = **findModel(id);
    return {id, 0x0072B2, &model, flatValues(model.text, parameters)};
}

} // namespace reflectance::test
