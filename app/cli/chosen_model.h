// The model that a verb was given: of the catalogue by --model, or the user's own by --model-file.
#pragma once

#include "core/reflectance/catalogue.h"

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

namespace reflectance::cli {

struct ModelChoice {
    std::string id = {};   ///< of the catalogue
    std::string file = {}; ///< of an own text; empty: none
    bool isGiven = false;  ///< --model was
};

/// `about` says what the model is for.
std::vector<CLI::Option*> addModelChoice(CLI::App& verb, ModelChoice& choice, const std::string& about);

/// Refused: none or both of the flags, an unknown id, a text with an error.
[[nodiscard]] Result<std::shared_ptr<const Model>> chosenModel(const ModelChoice& choice);

/// Values from name=value, each told with `flag` where it is wrong.
[[nodiscard]] Result<std::vector<double>>
valuesFrom(const ModelText& model, const std::vector<std::string>& assignments, const std::string& flag);

} // namespace reflectance::cli
