#include "core/geometry/readers.h"
#include "core/geometry/text_cursor.h"
#include "core/geometry/weld.h"

#include <array>
#include <bit>
#include <cstring>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t headerSize = 84;
constexpr std::size_t facetSize = 50;

std::uint32_t littleEndian(const char* bytes)
{
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return value;
}

Vec3d pointAt(const char* bytes)
{
    const auto component = [bytes](std::size_t i) {
        return static_cast<double>(std::bit_cast<float>(littleEndian(bytes + 4 * i)));
    };
    return {component(0), component(1), component(2)};
}

/// "facet" begins text; binary files may begin with "solid" all the same, so that word alone proves nothing.
bool isAscii(std::string_view bytes)
{
    return bytes.substr(0, 4096).find('\0') == std::string_view::npos;
}

Result<void> readBinary(std::string_view bytes, ReadContext& context, PolygonSoup& soup)
{
    soup.format = "STL (binary)";
    if (bytes.size() < headerSize)
        return Error{"is too short for an STL file; the file is cut short or damaged", context.file};
    const std::size_t announced = littleEndian(bytes.data() + headerSize - 4);
    const std::size_t present = (bytes.size() - headerSize) / facetSize;
    if (announced > present)
        context.warnings.add("the file ends before everything it announces", 0,
                             "facets " + std::to_string(present) + " of " + std::to_string(announced));
    else if (bytes.size() != headerSize + announced * facetSize)
        context.warnings.add("bytes after the last facet were not read", 0);
    for (std::size_t i = 0; i < std::min(announced, present); ++i) {
        if (i % 65536 == 0 && !context.goOn(static_cast<double>(i) / static_cast<double>(present)))
            return context.stopped();
        const char* const facet = bytes.data() + headerSize + i * facetSize;
        for (std::size_t corner = 1; corner <= 3; ++corner)
            soup.positions.push_back(pointAt(facet + 12 * corner));
        soup.faceEnds.push_back(static_cast<Index>(soup.positions.size()));
    }
    return {};
}

bool isWord(std::string_view word, std::string_view wanted)
{
    if (word.size() != wanted.size())
        return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if ((word[i] | 0x20) != wanted[i])
            return false;
    return true;
}

Vec3d readPoint(TextCursor& cursor, ReadContext& context)
{
    std::array<double, 3> v{};
    for (double& component : v) {
        const auto number = cursor.number();
        if (!number) {
            context.warnings.add("a vertex without three numbers", cursor.line());
            return {nan, nan, nan};
        }
        component = *number;
    }
    return {v[0], v[1], v[2]};
}

Result<void> readAscii(std::string_view text, ReadContext& context, PolygonSoup& soup)
{
    soup.format = "STL (ascii)";
    TextCursor cursor(text);
    long faceLine = 1;
    const auto endFace = [&] {
        if (soup.positions.size() == (soup.faceEnds.empty() ? 0 : soup.faceEnds.back()))
            return;
        soup.faceEnds.push_back(static_cast<Index>(soup.positions.size()));
        soup.faceLines.push_back(static_cast<Index>(faceLine));
    };
    for (std::size_t lines = 0; cursor.toNextContent(); ++lines) {
        if (lines % 65536 == 0 &&
            !context.goOn(static_cast<double>(cursor.offset()) / static_cast<double>(text.size())))
            return context.stopped();
        const std::string_view word = cursor.word();
        if (isWord(word, "vertex")) {
            soup.positions.push_back(readPoint(cursor, context));
        } else if (isWord(word, "facet")) {
            endFace(); // of a facet whose end is missing
            faceLine = cursor.line();
        } else if (isWord(word, "endloop") || isWord(word, "endfacet")) {
            endFace();
        }
        cursor.nextLine();
    }
    endFace();
    return {};
}

/// STL repeats every point for each of its triangles: equal ones become one vertex.
void weld(PolygonSoup& soup, int threads)
{
    soup.corners = firstAtSamePlace(soup.positions, threads);
    std::vector<Index> place(soup.positions.size());
    Index kept = 0;
    for (Index i = 0; i < soup.positions.size(); ++i)
        if (soup.corners[i] == i) {
            place[i] = kept;
            soup.positions[kept++] = soup.positions[i];
        }
    soup.positions.resize(kept);
    for (Index& corner : soup.corners)
        corner = place[corner];
}

} // namespace

Result<PolygonSoup> readStl(std::string_view bytes, ReadContext& context)
{
    PolygonSoup soup;
    const Result<void> done = isAscii(bytes) ? readAscii(bytes, context, soup) : readBinary(bytes, context, soup);
    if (!done)
        return done.error();
    weld(soup, context.threads);
    soup.notes.emplace_back("STL knows one normal per facet; they were computed anew from the triangles");
    return soup;
}

} // namespace reflectance
