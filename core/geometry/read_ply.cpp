#include "core/geometry/ply_blocks.h"
#include "core/geometry/ply_header.h"
#include "core/geometry/readers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Values of an ascii file: one element per line.
class AsciiValues {
public:
    AsciiValues(std::string_view bytes, TextCursor cursor) : size_(bytes.size()), cursor_(cursor) {}

    bool begin() { return cursor_.toNextContent(); }
    void end() { cursor_.nextLine(); }
    std::optional<double> next(PlyType) { return cursor_.atLineEnd() ? std::nullopt : cursor_.number(); }
    [[nodiscard]] long line() const { return cursor_.line(); }
    [[nodiscard]] double done() const { return static_cast<double>(cursor_.offset()) / static_cast<double>(size_); }
    [[nodiscard]] static bool isCutShort() { return false; } ///< a short line spoils one element, not the rest
    template <class Read> static bool atOnce(const Read&) { return false; }

private:
    std::size_t size_;
    TextCursor cursor_;
};

/// Values of a binary file; once it ends, every further value is missing.
class BinaryValues {
public:
    BinaryValues(std::string_view bytes, std::size_t offset, bool swap) : bytes_(bytes), at_(offset), swap_(swap) {}

    bool begin() const { return at_ < bytes_.size(); }
    void end() const {}
    [[nodiscard]] static long line() { return 0; }
    [[nodiscard]] double done() const { return static_cast<double>(at_) / static_cast<double>(bytes_.size()); }
    [[nodiscard]] bool isCutShort() const { return isCutShort_; }

    /// Whether read(bytes), which returns how many it used, could use what lies ahead.
    template <class Read> bool atOnce(const Read& read)
    {
        const std::size_t used = swap_ || isCutShort_ ? 0 : read(bytes_.substr(at_));
        at_ += used;
        return used > 0;
    }

    std::optional<double> next(PlyType type)
    {
        switch (type) {
        case PlyType::Int8:
            return as<std::int8_t>();
        case PlyType::Uint8:
            return as<std::uint8_t>();
        case PlyType::Int16:
            return as<std::int16_t>();
        case PlyType::Uint16:
            return as<std::uint16_t>();
        case PlyType::Int32:
            return as<std::int32_t>();
        case PlyType::Uint32:
            return as<std::uint32_t>();
        case PlyType::Float32:
            return as<float>();
        case PlyType::Float64:
            return as<double>();
        }
        return std::nullopt;
    }

private:
    template <class Number> std::optional<double> as()
    {
        std::array<char, sizeof(Number)> raw;
        if (bytes_.size() - at_ < raw.size()) {
            isCutShort_ = true;
            return std::nullopt;
        }
        std::memcpy(raw.data(), bytes_.data() + at_, raw.size());
        at_ += raw.size();
        if (swap_)
            std::reverse(raw.begin(), raw.end());
        return static_cast<double>(std::bit_cast<Number>(raw));
    }

    std::string_view bytes_;
    std::size_t at_;
    bool swap_;
    bool isCutShort_ = false;
};

/// Where a vertex property goes: 0..2 position, 3..5 normal, 6 nowhere.
std::size_t slotOf(const PlyProperty& property)
{
    static constexpr std::array<std::string_view, 6> names{"x", "y", "z", "nx", "ny", "nz"};
    const auto found = std::find(names.begin(), names.end(), property.name);
    return property.countType ? names.size() : static_cast<std::size_t>(found - names.begin());
}

bool hasNormals(const PlyElement& element)
{
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [](const PlyProperty& p) { return slotOf(p) == 5; });
}

bool isIndexList(const PlyProperty& property)
{
    return property.countType && (property.name == "vertex_indices" || property.name == "vertex_index");
}

Index indexFrom(double value)
{
    return value >= 0.0 && value < static_cast<double>(PolygonSoup::none) ? static_cast<Index>(value)
                                                                          : PolygonSoup::none;
}

template <class Values> class PlyBody {
public:
    PlyBody(Values values, ReadContext& context, PolygonSoup& soup) : values_(values), context_(context), soup_(soup) {}

    /// False when the reading was stopped from outside.
    bool read(const PlyHeader& header)
    {
        for (const PlyElement& element : header.elements)
            if (!element.properties.empty() && !readElements(element))
                return false;
        return true;
    }

private:
    bool readElements(const PlyElement& element)
    {
        if (readAtOnce(element)) {
            cornersBefore_ = soup_.corners.size();
            return context_.goOn(values_.done());
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            if (i % 65536 == 0 && !context_.goOn(values_.done()))
                return false;
            if (values_.isCutShort() || !values_.begin()) {
                context_.warnings.add("the file ends before everything it announces", values_.line(),
                                      quoted(element.name) + " " + std::to_string(i) + " of " +
                                          std::to_string(element.count));
                return true;
            }
            if (element.name == "vertex")
                readVertex(element);
            else if (element.name == "face")
                readFace(element);
            else
                skip(element);
            values_.end();
        }
        return true;
    }

    bool readAtOnce(const PlyElement& element)
    {
        const auto block =
            element.name == "vertex" ? readVertexBlock : (element.name == "face" ? readTriangleBlock : nullptr);
        return block &&
               values_.atOnce([&](std::string_view bytes) { return block(element, bytes, context_.threads, soup_); });
    }

    void readVertex(const PlyElement& element)
    {
        std::array<double, 7> v{nan, nan, nan, nan, nan, nan, nan};
        for (const PlyProperty& property : element.properties) {
            if (property.countType) {
                skipList(property);
                continue;
            }
            const auto value = values_.next(property.type);
            if (!value) {
                context_.warnings.add("a vertex lacks some of its numbers", values_.line());
                break;
            }
            v[slotOf(property)] = *value;
        }
        soup_.positions.emplace_back(v[0], v[1], v[2]);
        if (hasNormals(element))
            soup_.normals.emplace_back(v[3], v[4], v[5]);
    }

    void readFace(const PlyElement& element)
    {
        for (const PlyProperty& property : element.properties)
            if (isIndexList(property))
                readIndices(property);
            else
                skipValue(property);
        endFace();
        if (values_.line() > 0)
            soup_.faceLines.push_back(static_cast<Index>(values_.line()));
    }

    /// Ends of faces are kept from the first face on that is no triangle.
    void endFace()
    {
        const std::size_t corners = soup_.corners.size();
        const bool isTriangle = soup_.faceEnds.empty() && corners == cornersBefore_ + 3;
        if (soup_.faceEnds.empty() && !isTriangle)
            for (std::size_t end = 3; end <= cornersBefore_; end += 3)
                soup_.faceEnds.push_back(static_cast<Index>(end));
        if (!isTriangle)
            soup_.faceEnds.push_back(static_cast<Index>(corners));
        cornersBefore_ = corners;
    }

    void readIndices(const PlyProperty& property)
    {
        const double count = values_.next(*property.countType).value_or(0.0);
        for (double i = 0; i < count; ++i) {
            const auto value = values_.next(property.type);
            soup_.corners.push_back(value ? indexFrom(*value) : PolygonSoup::none);
            if (!value) {
                context_.warnings.add("a face lists fewer indices than it announces", values_.line());
                return;
            }
        }
    }

    void skip(const PlyElement& element)
    {
        for (const PlyProperty& property : element.properties)
            skipValue(property);
    }

    void skipValue(const PlyProperty& property)
    {
        if (property.countType)
            skipList(property);
        else
            (void)values_.next(property.type);
    }

    void skipList(const PlyProperty& property)
    {
        const double count = values_.next(*property.countType).value_or(0.0);
        for (double i = 0; i < count && values_.next(property.type); ++i)
            continue;
    }

    Values values_;
    ReadContext& context_;
    PolygonSoup& soup_;
    std::size_t cornersBefore_ = 0; ///< of all faces but the one that is being read
};

const char* formatName(PlyEncoding encoding)
{
    switch (encoding) {
    case PlyEncoding::LittleEndian:
        return "PLY (binary, little-endian)";
    case PlyEncoding::BigEndian:
        return "PLY (binary, big-endian)";
    case PlyEncoding::Ascii:
        break;
    }
    return "PLY (ascii)";
}

} // namespace

Result<PolygonSoup> readPly(std::string_view bytes, ReadContext& context)
{
    TextCursor cursor(bytes);
    const auto header = readPlyHeader(cursor, context.file);
    if (!header)
        return header.error();
    PolygonSoup soup;
    soup.format = formatName(header->encoding);
    const bool isBig = header->encoding == PlyEncoding::BigEndian;
    const bool swap = isBig != (std::endian::native == std::endian::big);
    const bool goOn = header->encoding == PlyEncoding::Ascii
                          ? PlyBody(AsciiValues(bytes, cursor), context, soup).read(*header)
                          : PlyBody(BinaryValues(bytes, cursor.offset(), swap), context, soup).read(*header);
    if (!goOn)
        return context.stopped();
    soup.normalOfVertex = !soup.normals.empty();
    return soup;
}

} // namespace reflectance
