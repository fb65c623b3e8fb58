#include "core/geometry/ply_header.h"

#include "core/base/text.h"
#include "core/geometry/warnings.h"

#include <array>

namespace reflectance {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr std::array typeNames{
    TypeName{"char", PlyType::Int8},      TypeName{"int8", PlyType::Int8},       TypeName{"uchar", PlyType::Uint8},
    TypeName{"uint8", PlyType::Uint8},    TypeName{"short", PlyType::Int16},     TypeName{"int16", PlyType::Int16},
    TypeName{"ushort", PlyType::Uint16},  TypeName{"uint16", PlyType::Uint16},   TypeName{"int", PlyType::Int32},
    TypeName{"int32", PlyType::Int32},    TypeName{"uint", PlyType::Uint32},     TypeName{"uint32", PlyType::Uint32},
    TypeName{"float", PlyType::Float32},  TypeName{"float32", PlyType::Float32}, TypeName{"double", PlyType::Float64},
    TypeName{"float64", PlyType::Float64}};

std::optional<PlyType> typeNamed(std::string_view name)
{
    for (const TypeName& known : typeNames)
        if (known.name == name)
            return known.type;
    return std::nullopt;
}

std::optional<PlyEncoding> encodingNamed(std::string_view name)
{
    if (name == "ascii")
        return PlyEncoding::Ascii;
    if (name == "binary_little_endian")
        return PlyEncoding::LittleEndian;
    if (name == "binary_big_endian")
        return PlyEncoding::BigEndian;
    return std::nullopt;
}

/// The sentence for a property line that cannot be used, or nothing.
std::optional<std::string> readProperty(TextCursor& cursor, PlyHeader& header)
{
    if (header.elements.empty())
        return "a property stands before the first element";
    PlyProperty property;
    std::string_view word = cursor.word();
    if (word == "list") {
        property.countType = typeNamed(cursor.word());
        if (!property.countType)
            return "the list's count has no known type";
        word = cursor.word();
    }
    const auto type = typeNamed(word);
    if (!type)
        return "the property type " + quoted(word) + " is not known";
    property.type = *type;
    property.name = cursor.word();
    header.elements.back().properties.push_back(std::move(property));
    return std::nullopt;
}

std::optional<std::string> readElement(TextCursor& cursor, PlyHeader& header)
{
    PlyElement element;
    element.name = cursor.word();
    const auto count = parseInteger(cursor.word());
    if (!count || *count < 0)
        return "the number of elements " + quoted(element.name) + " is not a count";
    element.count = static_cast<std::size_t>(*count);
    header.elements.push_back(std::move(element));
    return std::nullopt;
}

/// One header line; the sentence for what is wrong with it, or nothing.
std::optional<std::string> readLine(std::string_view keyword, TextCursor& cursor, PlyHeader& header, bool& hasFormat)
{
    if (keyword == "comment" || keyword == "obj_info" || keyword == "ply")
        return std::nullopt;
    if (keyword == "element")
        return readElement(cursor, header);
    if (keyword == "property")
        return readProperty(cursor, header);
    if (keyword != "format")
        return quoted(keyword) + " is not a PLY header line";
    const auto encoding = encodingNamed(cursor.word());
    if (!encoding)
        return "the format is none of ascii, binary_little_endian, binary_big_endian";
    header.encoding = *encoding;
    hasFormat = true;
    return std::nullopt;
}

} // namespace

std::size_t sizeOf(PlyType type)
{
    static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

Result<PlyHeader> readPlyHeader(TextCursor& cursor, const std::string& file)
{
    PlyHeader header;
    bool hasFormat = false;
    while (cursor.toNextContent()) {
        const long line = cursor.line();
        const std::string_view keyword = cursor.word();
        if (keyword == "end_header") {
            cursor.nextLine();
            if (!hasFormat)
                return Error{"the PLY header has no format line; export the mesh again", file, line};
            return header;
        }
        if (const auto fault = readLine(keyword, cursor, header, hasFormat))
            return Error{*fault + "; export the mesh again", file, line};
        cursor.nextLine();
    }
    return Error{"the PLY header does not end (no end_header); the file is cut short or damaged", file, cursor.line()};
}

} // namespace reflectance
