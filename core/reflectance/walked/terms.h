// The terms of a formula: what shade() adds up at its end, each of which can be seen alone or left out.
#pragma once

#include "core/reflectance/model_text.h"
#include "core/reflectance/walked/tree.h"

#include <string>
#include <vector>

namespace reflectance::walked {

struct Term {
    NodeId node = 0;
    std::string source; ///< as the text has it, on one line
    std::string name;   ///< "diffuse", "specular" or "term 2"
};

/// The summands of the last return of shade(); one, the whole of it, where it is no sum of colours.
[[nodiscard]] std::vector<Term> termsOf(const Tree& tree);

/// The text with 0 in the place of the terms that are not kept; `keep` has one entry per term. Lines stay where they are.
[[nodiscard]] ModelText withTerms(const ModelText& text, const Tree& tree, const std::vector<bool>& keep);

} // namespace reflectance::walked
