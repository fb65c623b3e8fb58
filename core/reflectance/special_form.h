// Cheaper types for what a model's text computes with, where the values allow: the text stays the same, in C++ and in GLSL,
// and so does every value, by ==. Only products with 0 are left out, and products that are three times the same.
#pragma once

#include "core/reflectance/model_text.h"

#include <span>
#include <string>
#include <vector>

namespace reflectance {

enum class MatrixForm { Full, Diagonal, Grey, Zero }; ///< of the parameter K
enum class ColorForm { Three, One };                  ///< of the parameter ks

struct SpecialForm {
    MatrixForm K = MatrixForm::Full;
    ColorForm ks = ColorForm::Three;
    bool facing = false; ///< black where N.V <= 0, which the text itself does not say

    friend bool operator==(const SpecialForm&, const SpecialForm&) = default;

    /// "+diagonal+one"; empty for the general form.
    [[nodiscard]] std::string key() const;
};

/// The cheapest form that these values allow; never facing.
[[nodiscard]] SpecialForm specialFormOf(const ModelText& model, std::span<const double> values);

/// What a form leaves out, in sentences: "K: a diagonal, so 6 of its 9 products".
[[nodiscard]] std::vector<std::string> leftOutBy(const SpecialForm& form);

} // namespace reflectance
