#include "core/reflectance/viewer.h"

#include "core/base/text.h"

#include <algorithm>
#include <cctype>

namespace reflectance {
namespace {

bool isPartOfWord(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::size_t occurrences(std::string_view word, std::string_view text)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !isPartOfWord(text[at - 1]);
        count += begins && (end == text.size() || !isPartOfWord(text[end])) ? 1U : 0U;
    }
    return count;
}

} // namespace

bool looksAtViewer(const ModelText& model)
{
    const std::string_view code = model.code;
    const std::size_t name = code.find("vec3 shade(");
    const std::size_t end = name == std::string_view::npos ? name : code.find(')', name);
    if (end == std::string_view::npos || model.usesEnvironment || model.usesTable)
        return true;
    const std::size_t begin = code.find('(', name) + 1;
    const auto parameters = split(code.substr(begin, end - begin), ',');
    if (parameters.size() != 4)
        return true;
    const std::string_view third = trimmed(parameters[2]);
    const std::string_view viewer = third.substr(third.find_last_of(" \t\n") + 1);
    return occurrences(viewer, code) > 1;
}

} // namespace reflectance
