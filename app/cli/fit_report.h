// The figures of `fit` as a table and as JSON.
#pragma once

#include "core/study/fit/fit.h"
#include "core/study/fit/survey.h"

#include <nlohmann/json_fwd.hpp>

namespace reflectance::cli {

void print(const Model& model, const Observations& observations, const FitResult& fit, const FitOptions& options);
[[nodiscard]] nlohmann::ordered_json described(const Model& model, const Observations& observations,
                                               const FitResult& fit, const FitOptions& options);

/// One line per model: how far it is off, how often it is best, what it costs.
void print(const Survey& survey, double tolerance);
[[nodiscard]] nlohmann::ordered_json described(const Survey& survey, double tolerance);
/// One line per surface and model.
[[nodiscard]] std::string csvOf(const Survey& survey);

} // namespace reflectance::cli
