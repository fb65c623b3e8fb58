// The models as the tests export them.
#pragma once

#include "core/reflectance/own_model.h"
#include "core/study/exports/export_model.h"

#include <algorithm>
#include <stdexcept>

namespace reflectance::test {

/// The defaults, but K where it is 0 by default, so that its term is there. "own_wide" is the text in this folder.
inline ExportSubject subjectFor(const std::string& id)
{
    static const auto own = readOwnModel(std::string(OWN_MODELS) + "/own_wide.glsl");
    const Model* model = id == "own_wide" ? own.value().get() : findModel(id).value();
    ExportSubject subject{model, flatValues(model->text, {})};
    const std::vector<double>& body = (*findModel("lambert_color"))->text.find("K")->initial;
    if (const Parameter* K = model->text.find("K"))
        if (std::all_of(K->initial.begin(), K->initial.end(), [](double entry) { return entry == 0.0; }))
            std::copy(body.begin(), body.end(), subject.values.begin() + static_cast<std::ptrdiff_t>(K->offset));
    return subject;
}

/// Throws where there is nothing to replace: a planted fault must be there.
inline std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    const std::size_t at = text.find(what);
    if (at == std::string::npos)
        throw std::invalid_argument("the text does not hold " + what);
    return text.replace(at, what.size(), with);
}

} // namespace reflectance::test
