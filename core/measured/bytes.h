// Numbers in binary files, whatever the byte order of the machine. Internal to the readers.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace reflectance {

/// The little-endian number at `offset`; nothing where the bytes end before it does.
template <class Number> [[nodiscard]] std::optional<Number> littleEndian(std::string_view bytes, std::size_t offset)
{
    if (offset > bytes.size() || bytes.size() - offset < sizeof(Number))
        return std::nullopt;
    char raw[sizeof(Number)];
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        raw[std::endian::native == std::endian::little ? i : sizeof(Number) - 1 - i] = bytes[offset + i];
    Number value;
    std::memcpy(&value, raw, sizeof value);
    return value;
}

template <class Number> void appendLittleEndian(std::string& bytes, Number value)
{
    char raw[sizeof(Number)];
    std::memcpy(raw, &value, sizeof value);
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        bytes += raw[std::endian::native == std::endian::little ? i : sizeof(Number) - 1 - i];
}

} // namespace reflectance
