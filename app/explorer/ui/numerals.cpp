#include "app/explorer/ui/numerals.h"

#include "core/base/text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace reflectance::explorer {

namespace {

std::string raised(int exponent)
{
    constexpr std::array<const char*, 10> digits = {"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                                    "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text = exponent < 0 ? "\u207B" : "";
    for (const char c : std::to_string(std::abs(exponent)))
        text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

/// "1.900e-06" has the mantissa 1.9 and the exponent -6.
std::string withPower(double value, int digits)
{
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*e", digits - 1, value);
    const std::string text = buffer.data();
    const std::size_t e = text.find('e');
    const std::string mantissa = general(*parseNumber(text.substr(0, e)), digits);
    const int exponent = std::stoi(text.substr(e + 1));
    return (mantissa == "1" ? "" : mantissa + "\u00D7") + "10" + raised(exponent);
}

} // namespace

std::string written(double value, int digits)
{
    if (std::isnan(value))
        return "not a number";
    if (value < 0.0)
        return "\u2212" + written(-value, digits);
    if (std::isinf(value))
        return "\u221E";
    if (value != 0.0 && (value >= 99999.5 || value < 0.000999))
        return withPower(value, digits);
    return general(value, value >= 1000.0 ? 5 : digits); // %g would write 12345 as 1.234e+04
}

std::string grouped(std::size_t count)
{
    std::string text = std::to_string(count);
    for (std::size_t left = text.size(); left > 3; left -= 3)
        text.insert(left - 3, "\u2009");
    return text;
}

std::string duration(double milliseconds)
{
    return milliseconds < 999.5 ? written(milliseconds, 3) + " ms" : written(milliseconds / 1000.0, 3) + " s";
}

} // namespace reflectance::explorer
