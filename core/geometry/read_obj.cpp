#include "core/geometry/readers.h"
#include "core/geometry/text_cursor.h"

#include <array>

namespace reflectance {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class ObjReader {
public:
    ObjReader(std::string_view text, ReadContext& context) : text_(text), cursor_(text), context_(context)
    {
        soup_.format = "OBJ";
    }

    Result<PolygonSoup> read()
    {
        for (std::size_t lines = 0; cursor_.toNextContent(); ++lines) {
            if (lines % 65536 == 0 &&
                !context_.goOn(static_cast<double>(cursor_.offset()) / static_cast<double>(text_.size())))
                return context_.stopped();
            readLine(cursor_.word());
            cursor_.nextLine();
        }
        if (!anyNormal_)
            soup_.cornerNormals = {};
        if (hasMaterials_)
            soup_.notes.emplace_back("materials (mtllib, usemtl) are not read: the surface is this program's own");
        return std::move(soup_);
    }

private:
    void readLine(std::string_view keyword)
    {
        if (keyword == "v")
            soup_.positions.push_back(readVector("a vertex without three numbers"));
        else if (keyword == "vn")
            soup_.normals.push_back(readVector("a normal without three numbers"));
        else if (keyword == "f" || keyword == "fo")
            readFace();
        else if (keyword == "mtllib" || keyword == "usemtl")
            hasMaterials_ = true;
        else if (keyword == "l" || keyword == "p")
            context_.warnings.add("lines and points are not drawn", cursor_.line());
        else if (!isSilent(keyword))
            context_.warnings.add("a line that OBJ does not know was skipped", cursor_.line(), quoted(keyword));
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
                context_.warnings.add(complaint, cursor_.line());
                return {nan, nan, nan};
            }
            component = *number;
        }
        return {v[0], v[1], v[2]};
    }

    void readFace()
    {
        const long line = cursor_.line();
        while (!cursor_.atLineEnd())
            if (!readCorner()) {
                context_.warnings.add("a face with something that is not an index", line, quoted(cursor_.word()));
                break;
            }
        soup_.faceEnds.push_back(static_cast<PolygonSoup::Index>(soup_.corners.size()));
        soup_.faceLines.push_back(static_cast<PolygonSoup::Index>(line));
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
        soup_.corners.push_back(resolved(vertex.value_or(0), soup_.positions.size()));
        soup_.cornerNormals.push_back(resolved(normal.value_or(0), soup_.normals.size()));
        anyNormal_ = anyNormal_ || normal;
        return true;
    }

    bool isSpaceAhead() const { return cursor_.offset() == text_.size() || text_[cursor_.offset()] <= ' '; }

    /// 1-based, or counted back from the newest one; 0 and what lies before the first become `none`. Indices past the
    /// newest are kept: some files list faces first, and the range is checked at the end.
    static PolygonSoup::Index resolved(long long index, std::size_t soFar)
    {
        const long long zeroBased = index > 0 ? index - 1 : static_cast<long long>(soFar) + index;
        if (index == 0 || zeroBased < 0 || zeroBased >= static_cast<long long>(PolygonSoup::none))
            return PolygonSoup::none;
        return static_cast<PolygonSoup::Index>(zeroBased);
    }

    std::string_view text_;
    TextCursor cursor_;
    ReadContext& context_;
    PolygonSoup soup_;
    bool anyNormal_ = false;
    bool hasMaterials_ = false;
};

} // namespace

Result<PolygonSoup> readObj(std::string_view text, ReadContext& context)
{
    return ObjReader(text, context).read();
}

} // namespace reflectance
