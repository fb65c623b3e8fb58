// The catalogue of reflectance models: a Model is its text and its kernels.
#pragma once

#include "core/reflectance/kernel.h"
#include "core/reflectance/lobe_form.h"
#include "core/reflectance/model_text.h"
#include "core/reflectance/special_form.h"

#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace reflectance {

struct Kernels {
    Kernel<double> exact; ///< double: the truth
    Kernel<float> single; ///< scalar float
    Kernel<float> lanes;  ///< float in the widest lanes of this processor
};

struct Model : Kernels {
    ModelText text;
    std::vector<Kernels> otherLobes; ///< with the other forms of the lobe, in their order; empty where it calls none
    std::shared_ptr<const void> walked = {}; ///< of an own model: keeps alive what its kernels walk; null: compiled

    std::vector<std::pair<SpecialForm, Kernels>> specials; ///< the forms that have kernels of their own

    /// The model's own kernels where it has no lobe.
    [[nodiscard]] const Kernels& with(LobeForm form) const;
    /// The form's kernels with the conditioned lobe, or the model's own; the form must be one that the values allow.
    [[nodiscard]] const Kernels& with(const SpecialForm& form) const;

    [[nodiscard]] const std::string& id() const { return text.id; }
};

/// All models, in the order of the menus.
[[nodiscard]] const std::vector<Model>& catalogue();

/// The model with this id, or a sentence that names the nearest one.
[[nodiscard]] Result<const Model*> findModel(std::string_view id);

/// Parameter values by name. They outlive a change of model: names that two models share keep their value.
using ParameterValues = std::map<std::string, std::vector<double>, std::less<>>;

/// A parameter's numbers: from `values` where named there, spread as checkedValue does, else the default.
[[nodiscard]] std::vector<double> valueOf(const Parameter& parameter, const ParameterValues& values);

/// The model's flat list of values: valueOf for each parameter in turn. A list is filled up with 0; one that does not hold
/// what its choice asks for (see checkLists) counts as not named.
[[nodiscard]] std::vector<double> flatValues(const ModelText& model, const ParameterValues& values);

/// Checks count, choices and legal range and spreads one number over a colour, one over the diagonal of a matrix, three over its
/// diagonal. The error names the parameter, the value and the range.
[[nodiscard]] Result<std::vector<double>> checkedValue(const Parameter& parameter, std::span<const double> numbers);

/// Sets "name=1 2 3" (blanks or commas between numbers) for a model; the error names the nearest parameter.
[[nodiscard]] Result<void> setParameter(const ModelText& model, std::string_view assignment, ParameterValues& values);

} // namespace reflectance
