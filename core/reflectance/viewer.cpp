#include "core/reflectance/viewer.h"

#include "core/base/text.h"
#include "core/reflectance/words.h"

namespace reflectance {
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
