// The header of a PLY file: which elements follow, and of which properties each consists.
#pragma once

#include "core/base/result.h"
#include "core/geometry/text_cursor.h"

#include <optional>
#include <string>
#include <vector>

namespace reflectance {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

struct PlyProperty {
    std::string name;
    PlyType type{};                   ///< of the value, or of a list's items
    std::optional<PlyType> countType; ///< lists only
};

struct PlyElement {
    std::string name;
    std::size_t count = 0; ///< as announced; nothing may rely on it
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding{};
    std::vector<PlyElement> elements;
};

[[nodiscard]] std::size_t sizeOf(PlyType type);

/// Reads up to and including the line "end_header". `cursor` stands at the start of the file.
Result<PlyHeader> readPlyHeader(TextCursor& cursor, const std::string& file);

} // namespace reflectance
