// A formula taken apart: its tree, its terms, and each term as a model of its own.
#pragma once

#include "core/reflectance/catalogue.h"
#include "core/reflectance/walked/terms.h"
#include "core/reflectance/walked/tree.h"

#include <memory>
#include <vector>

namespace reflectance::walked {

struct Dissected {
    Tree tree;
    std::vector<Term> terms; ///< one, the whole of it, where the formula is no sum
    std::vector<std::shared_ptr<const Model>>
        alone; ///< one per term, under the id of the whole; none where there is one
};

/// Of a built-in text, or of an own one that has been read. Made once for each text and kept, so that asking again is cheap and
/// gives the same models. From any thread.
[[nodiscard]] std::shared_ptr<const Dissected> dissected(const ModelText& text);

} // namespace reflectance::walked
