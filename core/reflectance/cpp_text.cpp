#include "core/reflectance/cpp_text.h"

#include "core/reflectance/words.h"

#include <algorithm>
#include <cctype>

namespace reflectance {
namespace {

/// Whole numbers count and index; they are the same in every precision.
bool isWhole(std::string_view literal)
{
    return literal.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Length of the number literal at `at`, 0 if none starts there.
std::size_t numberLength(std::string_view code, std::size_t at)
{
    const auto digit = [&](std::size_t i) {
        return i < code.size() && std::isdigit(static_cast<unsigned char>(code[i])) != 0;
    };
    if (!digit(at) && !(code[at] == '.' && digit(at + 1)))
        return 0;
    std::size_t end = at;
    while (digit(end) || (end < code.size() && code[end] == '.'))
        ++end;
    if (end < code.size() && (code[end] == 'e' || code[end] == 'E')) {
        const std::size_t sign = (code[end + 1] == '-' || code[end + 1] == '+') ? 1 : 0;
        for (end += 1 + sign; digit(end);)
            ++end;
    }
    return end - at;
}

std::string typeNamed(std::string_view word)
{
    if (word == "uniform")
        return "";
    if (word == "float")
        return "T";
    if (word == "vec3")
        return "Vec3<T>";
    if (word == "vec4")
        return "Vec4<T>";
    if (word == "mat3")
        return "Mat3<T>";
    if (word == "samplerBuffer")
        return "TexelBuffer<T>";
    return std::string(word);
}

} // namespace

std::string instantiated(std::string_view code, bool keepComments)
{
    std::string out;
    for (std::size_t i = 0; i < code.size();) {
        if (code.substr(i, 2) == "//") {
            const std::size_t end = std::min(code.find('\n', i), code.size());
            if (keepComments)
                out += code.substr(i, end - i);
            i = end;
        } else if (const std::size_t length = numberLength(code, i)) {
            const std::string_view literal = code.substr(i, length);
            if (isWhole(literal))
                out += literal;
            else
                out.append("lit<T>(").append(literal).append(")");
            i += length;
        } else if (isWordLetter(code[i])) {
            std::size_t end = i;
            while (end < code.size() && isWordLetter(code[end]))
                ++end;
            out += typeNamed(code.substr(i, end - i));
            i = end;
        } else {
            out.push_back(code[i++]);
        }
    }
    return out;
}

} // namespace reflectance
