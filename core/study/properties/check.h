// Holds a model to what physics asks and what its text declares. A new model gets all of it without a line of test code.
#pragma once

#include "core/study/properties/ask.h"

#include <string>
#include <string_view>
#include <vector>

namespace reflectance::properties {

/// ExpectedFailure: the text says that the property does not hold, and it does not. Reported: nothing was promised.
enum class Verdict { Holds, ExpectedFailure, Reported, Broken };

[[nodiscard]] std::string_view nameOf(Verdict verdict);

/// What one property asks, how it is looked at, and how much is allowed and why.
struct PropertyText {
    std::string_view name;
    std::string_view asks;
    std::string_view method;
    double allowed = 0.0; ///< in the property's own measure
    std::string_view allowance;
};

struct PropertyResult {
    PropertyText property;
    Finding finding;
    bool holds = false;
    std::string declared; ///< the model's own words; empty where every model must have the property
    Verdict verdict = Verdict::Broken;
};

/// All properties that apply to the model, in the order of docs/properties.md.
[[nodiscard]] std::vector<PropertyResult> checkModel(const Model& model, const Effort& effort = {});

/// True if no verdict is Broken.
[[nodiscard]] bool asDeclared(const std::vector<PropertyResult>& results);

} // namespace reflectance::properties
