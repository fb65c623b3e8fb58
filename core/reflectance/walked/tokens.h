// The words of a shared text: what the walker's parser reads.
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace reflectance::walked {

struct Token {
    enum class Kind { Word, Number, Whole, Symbol, End };
    Kind kind = Kind::End;
    std::string_view text; ///< into the code
    std::size_t begin = 0; ///< offset into the code
    long line = 1;
    double number = 0.0; ///< of Number and Whole
};

/// The code as tokens, comments left out, with an End at its end. The error names what no text may hold, and its line.
[[nodiscard]] Result<std::vector<Token>> tokensOf(std::string_view code);

} // namespace reflectance::walked
