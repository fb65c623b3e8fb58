#include "core/study/goniometer/surface_words.h"

#include "core/base/text.h"

#include <algorithm>

namespace reflectance {

Result<SurfaceWords> SurfaceWords::parsed(std::string_view text, const std::vector<std::string>& known)
{
    SurfaceWords words;
    if (trimmed(text).empty())
        return words;
    for (const std::string_view piece : split(text, ',')) {
        const std::size_t equals = piece.find('=');
        const std::string name(trimmed(piece.substr(0, equals)));
        if (equals == std::string_view::npos)
            return Error{"\"" + std::string(piece) +
                         "\" says nothing; write NAME=VALUE with a NAME of: " + joined(known)};
        if (std::find(known.begin(), known.end(), name) == known.end())
            return Error{"knows no \"" + name + "\"; choose of: " + joined(known)};
        if (!words.given_.emplace(name, trimmed(piece.substr(equals + 1))).second)
            return Error{"says " + name + " twice"};
    }
    return words;
}

std::string SurfaceWords::word(std::string_view name, std::string otherwise) const
{
    const auto found = given_.find(name);
    return found == given_.end() ? std::move(otherwise) : found->second;
}

Result<double> SurfaceWords::number(std::string_view name, double otherwise, double low, double high) const
{
    const auto found = given_.find(name);
    if (found == given_.end())
        return otherwise;
    const auto value = parseNumber(found->second);
    if (!value || !(*value >= low && *value <= high))
        return Error{std::string(name) + " = " + found->second + " is not within " + general(low, 6) + " .. " +
                     general(high, 6)};
    return *value;
}

} // namespace reflectance
