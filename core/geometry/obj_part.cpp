#include "core/geometry/obj_part.h"

#include "core/geometry/plain_numbers.h"
#include "core/geometry/text_cursor.h"

#include <array>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class ObjPartReader {
public:
    ObjPartReader(std::string_view text, ObjPart& part) : text_(text), cursor_(text), part_(part) {}

    void read()
    {
        // Plain lines can be read without asking at each character whether the text ends: a line break stops them.
        const bool isClosed = text_.ends_with('\n');
        while (cursor_.toNextContent()) {
            if (isClosed && readPlainLine())
                continue;
            readLine(cursor_.word());
            cursor_.nextLine();
        }
        part_.lines = cursor_.line() - 1;
    }

private:
    /// Reads the line at once if it is one as nearly all are: v or vn with three decimal numbers, f with positive indices.
    bool readPlainLine()
    {
        const char* at = text_.data() + cursor_.offset();
        if (at[0] == 'v' && at[1] == 't' && at[2] == ' ') {
            cursor_.nextLine();
            return true;
        }
        const bool isNormal = at[0] == 'v' && at[1] == 'n';
        if (isNormal || (at[0] == 'v' && at[1] == ' '))
            return readPlainVector(at + (isNormal ? 2 : 1), isNormal ? part_.normals : part_.positions);
        return at[0] == 'f' && at[1] == ' ' && readPlainFace(at + 1);
    }

    bool readPlainVector(const char* at, std::vector<Vec3d>& vectors)
    {
        std::array<double, 3> v{};
        for (double& component : v)
            if (*at != ' ' || !(at = number(behindSpaces(at), component)))
                return false;
        if (!endLine(behindSpaces(at)))
            return false;
        vectors.emplace_back(v[0], v[1], v[2]);
        return true;
    }

    bool readPlainFace(const char* at)
    {
        PlainCorner corners[longestPlainFace];
        std::size_t count = 0;
        for (at = behindSpaces(at); *at != '\n' && *at != '\r'; at = behindSpaces(at), ++count)
            if (count == longestPlainFace || !(at = plainCorner(at, corners[count])))
                return false;
        const long line = cursor_.line();
        if (!endLine(at))
            return false;
        for (std::size_t i = 0; i < count; ++i)
            addCorner(corners[i].vertex - 1, corners[i].normal == 0 ? PolygonSoup::none : corners[i].normal - 1);
        endFace(count, line);
        return true;
    }

    static const char* behindSpaces(const char* at)
    {
        while (*at == ' ')
            ++at;
        return at;
    }

    /// As plainNumber, but of any number of digits and with exponent.
    const char* number(const char* at, double& value) const
    {
        if (const char* const behind = plainNumber(at, value))
            return behind;
        const auto [behind, error] = std::from_chars(at, text_.data() + text_.size(), value);
        const bool isClosed = error == std::errc{} && (*behind == ' ' || *behind == '\n' || *behind == '\r');
        return isClosed ? behind : nullptr;
    }

    /// Past a line break that stands here; otherwise false.
    bool endLine(const char* at)
    {
        const std::size_t length = *at == '\n' ? 1 : (at[0] == '\r' && at[1] == '\n' ? 2 : 0);
        if (length > 0)
            cursor_.jumpBehindLine(at + length);
        return length > 0;
    }

    void readLine(std::string_view keyword)
    {
        if (keyword == "v")
            part_.positions.push_back(readVector("a vertex without three numbers"));
        else if (keyword == "vn")
            part_.normals.push_back(readVector("a normal without three numbers"));
        else if (keyword == "f" || keyword == "fo")
            readFace();
        else if (keyword == "mtllib" || keyword == "usemtl")
            part_.hasMaterials = true;
        else if (keyword == "l" || keyword == "p")
            part_.warnings.add("lines and points are not drawn", cursor_.line());
        else if (!isSilent(keyword))
            part_.warnings.add("a line that OBJ does not know was skipped", cursor_.line(), quoted(keyword));
    }

    static bool isSilent(std::string_view keyword)
    {
        static constexpr std::array known{
            "vt",    "g",    "o",      "s",      "vp",         "cstype",    "deg",      "bmat",     "step",  "curv",
            "curv2", "surf", "parm",   "trim",   "hole",       "scrv",      "sp",       "end",      "con",   "mg",
            "bevel", "lod",  "maplib", "usemap", "shadow_obj", "trace_obj", "c_interp", "d_interp", "ctech", "stech"};
        for (const std::string_view name : known)
            if (keyword == name)
                return true;
        return false;
    }

    /// A damaged vector keeps its place as NaN, so that later indices do not shift.
    Vec3d readVector(std::string_view complaint)
    {
        std::array<double, 3> v{};
        for (double& component : v) {
            const auto number = cursor_.number();
            if (!number) {
                part_.warnings.add(complaint, cursor_.line());
                return {nan, nan, nan};
            }
            component = *number;
        }
        return {v[0], v[1], v[2]};
    }

    void readFace()
    {
        const long line = cursor_.line();
        const std::size_t before = part_.corners.size();
        while (!cursor_.atLineEnd())
            if (!readCorner()) {
                part_.warnings.add("a face with something that is not an index", line, quoted(cursor_.word()));
                break;
            }
        endFace(part_.corners.size() - before, line);
    }

    /// v, v/vt, v//vn or v/vt/vn; an empty place is allowed everywhere, though without a vertex the face is dropped.
    bool readCorner()
    {
        const auto vertex = cursor_.integer();
        bool hasMore = cursor_.accept('/');
        if (!vertex && !hasMore)
            return false;
        std::optional<long long> normal;
        if (hasMore) {
            if (!isSpaceAhead())
                (void)cursor_.integer();
            if (cursor_.accept('/') && !isSpaceAhead())
                normal = cursor_.integer();
        }
        if (normal)
            namesNormals();
        const Index vertexIndex = resolved(vertex.value_or(0), part_.positions.size(), part_.relativeCorners);
        addCorner(vertexIndex, resolved(normal.value_or(0), part_.normals.size(), part_.relativeNormals));
        return true;
    }

    bool isSpaceAhead() const { return cursor_.offset() == text_.size() || text_[cursor_.offset()] <= ' '; }

    /// 1-based, or counted back from the newest one; 0 and what lies before the first become `none`. Indices past the
    /// newest are kept: some files list faces first, and the range is checked at the end.
    Index resolved(long long index, std::size_t soFar, std::vector<RelativeIndex>& relative) const
    {
        if (index < 0)
            relative.push_back({part_.corners.size(), static_cast<long long>(soFar) + index});
        const bool isPossible = index > 0 && index <= static_cast<long long>(PolygonSoup::none);
        return isPossible ? static_cast<Index>(index - 1) : PolygonSoup::none;
    }

    void addCorner(Index vertex, Index normal)
    {
        if (normal != PolygonSoup::none)
            namesNormals();
        part_.corners.push_back(vertex);
        if (anyNormal_)
            part_.cornerNormals.push_back(normal);
    }

    /// From now on the part has a normal, or `none`, for every corner.
    void namesNormals()
    {
        if (!anyNormal_)
            part_.cornerNormals.assign(part_.corners.size(), PolygonSoup::none);
        anyNormal_ = true;
    }

    void endFace(std::size_t corners, long line)
    {
        if (corners != 3 && part_.faceEnds.empty())
            for (std::size_t i = 0; i < part_.faceLines.size(); ++i)
                part_.faceEnds.push_back(static_cast<Index>(3 * i + 3));
        if (corners != 3 || !part_.faceEnds.empty())
            part_.faceEnds.push_back(static_cast<Index>(part_.corners.size()));
        part_.faceLines.push_back(static_cast<Index>(line));
    }

    static constexpr std::size_t longestPlainFace = 8;

    std::string_view text_;
    TextCursor cursor_;
    ObjPart& part_;
    bool anyNormal_ = false;
};

} // namespace

void ObjPart::clear()
{
    positions.clear();
    normals.clear();
    for (auto* indices : {&corners, &cornerNormals, &faceEnds, &faceLines})
        indices->clear();
    relativeCorners.clear();
    relativeNormals.clear();
    warnings = {};
    lines = 0;
    hasMaterials = false;
}

void readObjPart(std::string_view text, ObjPart& part)
{
    ObjPartReader(text, part).read();
}

} // namespace reflectance
