#include "core/base/columns.h"

#include "core/base/text.h"

namespace reflectance {

std::vector<std::string_view> columnsOf(std::string_view line)
{
    for (const char separator : {',', ';', '\t'}) {
        if (line.find(separator) == std::string_view::npos)
            continue;
        auto fields = split(line, separator);
        for (std::string_view& field : fields)
            field = trimmed(field);
        return fields;
    }
    return words(line);
}

std::string_view withoutMark(std::string_view text)
{
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

} // namespace reflectance
