// What a formula did with its numbers at one place: each statement of shade() with its value, and the branches it took.
#pragma once

#include "core/reflectance/catalogue.h"
#include "core/reflectance/walked/tree.h"

#include <string>
#include <vector>

namespace reflectance::walked {

struct AccountLine {
    long line = 0;                  ///< of the text
    std::string name;               ///< what was assigned; "returned" at the end
    std::string expression;         ///< as the text has it
    std::string filled;             ///< the same with numbers in the place of names
    std::vector<double> numbers;    ///< the value: 1, 3 or 9
    std::vector<std::string> notes; ///< "gate: cosine = 0.83 > 0, open"; the rows of a matrix product, written out
};

/// Where the formula is looked at: unit vectors, the light as it arrives, its disc (see Frame::lightDisc).
struct Place {
    Vec3d N, L, V, I;
    double lightDisc = 0.0;
    MeasuredSurface<double> measured = {};
};

struct Account {
    std::vector<AccountLine> lines; ///< in the order in which they ran
    Vec3d value;                    ///< what shade() returned: that of the model's kernel in double, bit for bit
};

/// `tree` is that of the model's text, `values` its flat list of parameters.
[[nodiscard]] Account accountOf(const Tree& tree, const std::vector<double>& values, const Place& place);

} // namespace reflectance::walked
