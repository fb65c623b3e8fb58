// Words in the text of a model. As in GLSL, a word is made of letters, digits and underscores.
#pragma once

#include <cstddef>
#include <string_view>

namespace reflectance {

[[nodiscard]] constexpr bool isWordLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// How often `word` stands in `code` by itself, not within a longer word.
[[nodiscard]] constexpr std::size_t occurrences(std::string_view word, std::string_view code)
{
    std::size_t count = 0;
    for (std::size_t at = code.find(word); at != std::string_view::npos; at = code.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !isWordLetter(code[at - 1]);
        count += begins && (end == code.size() || !isWordLetter(code[end])) ? 1U : 0U;
    }
    return count;
}

} // namespace reflectance
