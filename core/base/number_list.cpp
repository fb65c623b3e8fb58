#include "core/base/number_list.h"

#include "core/base/text.h"

#include <cmath>

namespace reflectance {

std::optional<std::vector<double>> numberList(std::string_view text)
{
    std::vector<double> numbers;
    for (const std::string_view piece : split(text, ',')) {
        const auto number = parseNumber(trimmed(piece));
        if (!number || !std::isfinite(*number))
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

} // namespace reflectance
