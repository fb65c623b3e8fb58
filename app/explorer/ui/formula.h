// Turns a formula as the model texts write it, "K I (N.L) + ks I (R.V)^n", into pieces to be set: italic letters,
// subscripts, superscripts, a centred dot for the scalar product.
#pragma once

#include "core/reflectance/parameter.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance::explorer {

enum class PieceStyle { Upright, Italic, Subscript, Superscript };

struct FormulaPiece {
    std::string text;
    PieceStyle style = PieceStyle::Upright;
    bool mayBreakAfter = false; ///< a line may end here

    friend bool operator==(const FormulaPiece&, const FormulaPiece&) = default;
};

/// Names of parameters become their symbols: "ks" is set as k with the subscript s.
[[nodiscard]] std::vector<FormulaPiece> typeset(std::string_view formula, std::span<const Parameter> parameters = {});

} // namespace reflectance::explorer
