// The numbers that fill mesh files, read several times faster than by std::from_chars and to the same bit. What is not
// plainly written is left to others. All functions want a line break somewhere behind: it stops them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace reflectance {

/// Decimal digits; of more than 19 `value` holds nonsense.
struct PlainDigits {
    std::uint64_t value = 0;
    std::ptrdiff_t count = 0;
};

inline const char* plainDigits(const char* at, PlainDigits& digits)
{
    const char* const first = at;
    for (unsigned digit = static_cast<unsigned char>(*at) - '0'; digit < 10;
         digit = static_cast<unsigned char>(*++at) - '0')
        digits.value = 10 * digits.value + digit;
    digits.count += at - first;
    return at;
}

/// Reads -12.345 or 7 and returns what stands behind; null where something else is written, also an exponent or so many
/// digits that the result would not be the nearest double. Digits and power of ten are exact in double, so that their
/// quotient is rounded once (Clinger, How to Read Floating Point Numbers Accurately, 1990).
inline const char* plainNumber(const char* at, double& number)
{
    static constexpr std::array<double, 16> powersOfTen{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const bool isNegative = *at == '-';
    PlainDigits digits;
    at = plainDigits(at + (isNegative ? 1 : 0), digits);
    const std::ptrdiff_t whole = digits.count;
    std::ptrdiff_t decimals = 0;
    if (*at == '.') {
        at = plainDigits(at + 1, digits);
        decimals = digits.count - whole;
        if (decimals == 0)
            return nullptr;
    }
    const bool isMore = *at != ' ' && *at != '\n' && *at != '\r';
    if (whole == 0 || digits.count > 15 || isMore)
        return nullptr;
    const double size =
        static_cast<double>(static_cast<std::int64_t>(digits.value)) / powersOfTen[static_cast<std::size_t>(decimals)];
    number = isNegative ? -size : size;
    return at;
}

/// A corner of an OBJ face, 1-based; 0 where no normal is named.
struct PlainCorner {
    std::uint32_t vertex = 0;
    std::uint32_t normal = 0;
};

/// A positive index of at most nine digits; null for anything else.
inline const char* plainIndex(const char* at, std::uint32_t& index)
{
    PlainDigits digits;
    at = plainDigits(at, digits);
    index = static_cast<std::uint32_t>(digits.value);
    return digits.count == 0 || digits.count > 9 || digits.value == 0 ? nullptr : at;
}

/// Reads 3, 3/4, 3//5 or 3/4/5 and returns what stands behind, a blank or a line break; null where something else is
/// written.
inline const char* plainCorner(const char* at, PlainCorner& corner)
{
    std::uint32_t texture = 0;
    corner.normal = 0;
    at = plainIndex(at, corner.vertex);
    if (at && *at == '/' && at[1] != '/')
        at = plainIndex(at + 1, texture);
    else if (at && *at == '/')
        ++at;
    if (at && *at == '/')
        at = plainIndex(at + 1, corner.normal);
    return at && (*at == ' ' || *at == '\n' || *at == '\r') ? at : nullptr;
}

} // namespace reflectance
