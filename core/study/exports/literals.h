// Numbers and remarks as GLSL and C++ write them. Internal to the exports.
#pragma once

#include "core/math/vec.h"
#include "core/reflectance/model_text.h"
#include "core/reflectance/words.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance::exports {

/// Always with a point or an exponent; reads back to the same double.
[[nodiscard]] std::string literal(double value);

/// Rounded to float once, in nine digits.
[[nodiscard]] std::string floatLiteral(double value);

/// "a, b, c" of components, each by `one`.
[[nodiscard]] std::string triple(const Vec3d& v, std::string (*one)(double));

/// The id as the beginning of names: no two "_" together, none at the end, a letter first, which GLSL asks for.
[[nodiscard]] std::string codeName(std::string_view id);

/// What is said above every exported code: name, formula, citation, what the factor means, the parameters with their values.
[[nodiscard]] std::string headComment(const ModelText& model, const std::vector<double>& values);

/// Code with `renamed` applied to every identifier that stands neither in a // remark nor behind a point.
template <class Renamed> [[nodiscard]] std::string withNames(std::string_view code, const Renamed& renamed)
{
    std::string out;
    for (std::size_t i = 0; i < code.size();) {
        std::size_t end = i + 1;
        if (code.substr(i, 2) == "//") {
            end = std::min(code.find('\n', i), code.size());
            out += code.substr(i, end - i);
        } else if (isWordLetter(code[i])) {
            while (end < code.size() && isWordLetter(code[end]))
                ++end;
            const std::string_view word = code.substr(i, end - i);
            out += i > 0 && code[i - 1] == '.' ? std::string(word) : std::string(renamed(word));
        } else {
            out += code[i];
        }
        i = end;
    }
    return out;
}

} // namespace reflectance::exports
