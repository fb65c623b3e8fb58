// Only what the values require: terms that are 0 are left out, whole models included.
#pragma once

#include "core/reflectance/catalogue.h"

#include <span>
#include <string>
#include <vector>

namespace reflectance {

/// A model, its values and the form to run it in. In double its factor equals that of the model it was made from by ==, for
/// all finite directions and lights.
struct RequiredModel {
    const Model* model = nullptr;
    std::vector<double> values;
    SpecialForm form;
    std::vector<std::string> leftOut; ///< in sentences
};

/// Follows what the model's text declares to become exactly ("becomes lambert_color where ks=0 exactly"), as far as it
/// goes, then takes the cheapest form of what is left.
[[nodiscard]] RequiredModel requiredModel(const Model& model, std::span<const double> values);

/// The model as it is.
[[nodiscard]] RequiredModel generalModel(const Model& model, std::span<const double> values);

} // namespace reflectance
