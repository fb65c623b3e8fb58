#include "core/base/number_list.h"

#include "core/base/text.h"

#include <cmath>

namespace reflectance {
namespace {

std::optional<std::vector<double>> numbersOf(const std::vector<std::string_view>& pieces)
{
    std::vector<double> numbers;
    for (const std::string_view piece : pieces) {
        const auto number = parseNumber(trimmed(piece));
        if (!number || !std::isfinite(*number))
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

} // namespace

std::optional<std::vector<double>> numberList(std::string_view text)
{
    return numbersOf(split(text, ','));
}

std::optional<std::vector<double>> numbersInWords(std::string_view text)
{
    return numbersOf(words(text));
}

} // namespace reflectance
