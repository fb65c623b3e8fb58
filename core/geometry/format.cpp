#include "core/base/text.h"
#include "core/geometry/readers.h"

#include <algorithm>
#include <optional>

namespace reflectance {
namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

enum class Format { Obj, Ply, Off, Stl };

/// The first word that is not in a comment, in the form in which formats begin.
std::string_view firstWord(std::string_view text)
{
    std::size_t at = 0;
    while (at < text.size()) {
        at = text.find_first_not_of(" \t\r\n\v\f", at);
        if (at == std::string_view::npos || text[at] != '#')
            break;
        at = text.find_first_of("\r\n", at);
    }
    if (at >= text.size())
        return {};
    const std::string_view rest = text.substr(at, 80);
    return rest.substr(0, std::min(rest.find_first_of(" \t\r\n\v\f"), rest.size()));
}

bool isText(std::string_view bytes)
{
    return bytes.substr(0, headOfFile).find('\0') == std::string_view::npos;
}

/// A binary STL has an 80-byte title, a 32-bit count and 50 bytes for each triangle.
bool hasBinaryStlSize(std::string_view bytes, std::uintmax_t fileSize)
{
    if (bytes.size() < 84)
        return false;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
        count |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[80 + i])) << (8 * i);
    return fileSize == 84 + 50 * count;
}

bool isObjWord(std::string_view word)
{
    static constexpr std::string_view known[] = {"v", "vn", "vt", "vp", "f",      "fo",    "g",
                                                 "o", "s",  "p",  "l",  "mtllib", "usemtl"};
    return std::find(std::begin(known), std::end(known), word) != std::end(known);
}

bool isOffWord(std::string_view word)
{
    return word.size() >= 3 && word.size() <= 8 && word.ends_with("OFF");
}

/// `bytes` are the file's first `headOfFile` at least.
std::optional<Format> formatOf(std::string_view bytes, std::uintmax_t fileSize, std::string_view extension)
{
    const std::string_view word = firstWord(bytes);
    if (word == "ply")
        return Format::Ply;
    if (hasBinaryStlSize(bytes, fileSize) && (extension == "stl" || !isText(bytes)))
        return Format::Stl;
    if (!isText(bytes))
        return extension == "stl" ? std::optional(Format::Stl) : std::nullopt;
    if (lowered(word) == "solid" || lowered(word) == "facet")
        return Format::Stl;
    if (isOffWord(word) || extension == "off")
        return Format::Off;
    if (isObjWord(word) || extension == "obj")
        return Format::Obj;
    return std::nullopt;
}

std::optional<Error> whyNoMesh(std::string_view bytes, const std::string& file)
{
    if (bytes.empty())
        return Error{"is empty; choose a mesh file", file};
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
        return Error{"is UTF-16 text; save it as UTF-8 or plain ASCII", file};
    if (bytes.starts_with("\x1F\x8B") || bytes.starts_with("PK\x03\x04") || bytes.starts_with("BZh") ||
        bytes.starts_with("\xFD"
                          "7zXZ"))
        return Error{"is a compressed archive; unpack it first", file};
    return std::nullopt;
}

Error unknownFormat(const std::string& file)
{
    return {"is not a mesh of a known format; OBJ, PLY, OFF and STL can be read", file};
}

} // namespace

std::optional<Error> whyNoMesh(const FileHead& head, std::string_view extension, const std::string& file)
{
    if (auto error = whyNoMesh(head.bytes, file))
        return error;
    // The first word of a text may stand behind longer comments than the head.
    const bool isUnknown = !isText(head.bytes) && !formatOf(head.bytes, head.fileSize, extension);
    return isUnknown ? std::optional(unknownFormat(file)) : std::nullopt;
}

bool isSurelyObj(const FileHead& head, std::string_view extension)
{
    std::string_view bytes = head.bytes;
    if (bytes.starts_with(byteOrderMark))
        bytes.remove_prefix(byteOrderMark.size());
    const std::string_view word = firstWord(bytes);
    const bool isWhole = !word.empty() && word.data() + word.size() < bytes.data() + bytes.size();
    return isWhole && !whyNoMesh(bytes, "") && formatOf(bytes, head.fileSize, extension) == Format::Obj;
}

Result<PolygonSoup> readSoup(std::string_view bytes, std::string_view extension, ReadContext& context)
{
    if (bytes.starts_with(byteOrderMark))
        bytes.remove_prefix(byteOrderMark.size());
    if (auto error = whyNoMesh(bytes, context.file))
        return *error;
    const auto format = formatOf(bytes, bytes.size(), extension);
    if (!format)
        return unknownFormat(context.file);
    switch (*format) {
    case Format::Obj:
        return readObj(TextParts(bytes), context);
    case Format::Ply:
        return readPly(bytes, context);
    case Format::Off:
        return readOff(bytes, context);
    case Format::Stl:
        return readStl(bytes, context);
    }
    return unknownFormat(context.file);
}

} // namespace reflectance
