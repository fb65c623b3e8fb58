// The rows of `eval`: CSV text in, observations out. See --help of eval for the columns.
#pragma once

#include "core/base/result.h"
#include "core/reflectance/observation.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace reflectance::cli {

struct EvalRow {
    std::string id;
    std::shared_ptr<const Model> own; ///< keeps `model` alive where it is none of the catalogue
    const Model* model = nullptr;
    std::vector<double> values;                 ///< flat, of the model
    std::shared_ptr<const MeasuredTable> table; ///< of a model that looks one up
    Observation observation;
};

struct EvalRows {
    std::vector<EvalRow> rows;
    std::vector<Error> bad; ///< rows that were left out, by line and column
};

/// An error only where the header itself cannot be used. `own`: a model that rows may name besides those of the catalogue.
[[nodiscard]] Result<EvalRows> parseEvalRows(std::string_view csv, const std::string& file,
                                             const std::shared_ptr<const Model>& own = nullptr);

} // namespace reflectance::cli
