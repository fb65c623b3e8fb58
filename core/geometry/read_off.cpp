#include "core/base/text.h"
#include "core/geometry/readers.h"
#include "core/geometry/text_cursor.h"

#include <array>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class OffReader {
public:
    OffReader(std::string_view text, ReadContext& context) : text_(text), cursor_(text), context_(context) {}

    Result<PolygonSoup> read()
    {
        if (auto bad = readHeader(); !bad)
            return bad.error();
        for (long long i = 0; i < vertexCount_ && isThere("vertices", i, vertexCount_); ++i) {
            if (i % 65536 == 0 && !context_.goOn(done()))
                return context_.stopped();
            readVertex();
        }
        for (long long i = 0; i < faceCount_ && isThere("faces", i, faceCount_); ++i) {
            if (i % 65536 == 0 && !context_.goOn(done()))
                return context_.stopped();
            readFace();
        }
        soup_.normalOfVertex = !soup_.normals.empty();
        return std::move(soup_);
    }

private:
    Result<void> readHeader()
    {
        if (!cursor_.toNextContent())
            return Error{"holds only comments; choose a mesh file", context_.file};
        soup_.format = "OFF";
        if (TextCursor ahead = cursor_; !parseInteger(ahead.word())) // the keyword is optional
            if (auto bad = readKeyword(); !bad)
                return bad;
        (void)cursor_.toNextContent();
        const long line = cursor_.line();
        const auto vertices = cursor_.integer();
        const auto faces = cursor_.integer();
        if (!vertices || !faces || *vertices < 0 || *faces < 0)
            return Error{"the counts of vertices and faces are missing; OFF needs them after its first word",
                         context_.file, line};
        vertexCount_ = *vertices;
        faceCount_ = *faces;
        cursor_.nextLine();
        return {};
    }

    /// [ST][C][N]OFF, the counts possibly right behind it. What else OFF knows (binary, more dimensions) is rare and
    /// refused by name.
    Result<void> readKeyword()
    {
        TextCursor ahead = cursor_;
        const std::string word(ahead.word());
        if (cursor_.accept('S'))
            (void)cursor_.accept('T');
        (void)cursor_.accept('C');
        hasNormals_ = cursor_.accept('N');
        if (!cursor_.accept('O') || !cursor_.accept('F') || !cursor_.accept('F'))
            return Error{quoted(word) + " is no OFF variant that can be read; use OFF, NOFF or COFF", context_.file,
                         cursor_.line()};
        soup_.format = word.substr(0, word.find("OFF") + 3);
        if (ahead.word() == "BINARY")
            return Error{"binary OFF cannot be read; save it as text", context_.file, cursor_.line()};
        return {};
    }

    bool isThere(const char* what, long long index, long long count)
    {
        if (cursor_.toNextContent())
            return true;
        context_.warnings.add("the file ends before everything it announces", cursor_.line(),
                              std::string(what) + " " + std::to_string(index) + " of " + std::to_string(count));
        return false;
    }

    void readVertex()
    {
        soup_.positions.push_back(readVector("a vertex without three numbers"));
        if (hasNormals_)
            soup_.normals.push_back(readVector("a normal without three numbers"));
        cursor_.nextLine(); // colours and texture coordinates follow
    }

    Vec3d readVector(std::string_view complaint)
    {
        std::array<double, 3> v{};
        for (double& component : v) {
            const auto number = cursor_.atLineEnd() ? std::nullopt : cursor_.number();
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
        const long long count = cursor_.integer().value_or(0);
        for (long long i = 0; i < count; ++i) {
            const auto index = cursor_.atLineEnd() ? std::nullopt : cursor_.integer();
            const bool isPossible = index && *index >= 0 && *index < static_cast<long long>(PolygonSoup::none);
            soup_.corners.push_back(isPossible ? static_cast<Index>(*index) : PolygonSoup::none);
            if (!index) {
                context_.warnings.add("a face lists fewer indices than it announces", line);
                break;
            }
        }
        soup_.faceEnds.push_back(static_cast<Index>(soup_.corners.size()));
        soup_.faceLines.push_back(static_cast<Index>(line));
        cursor_.nextLine(); // a colour may follow
    }

    [[nodiscard]] double done() const
    {
        return static_cast<double>(cursor_.offset()) / static_cast<double>(text_.size());
    }

    std::string_view text_;
    TextCursor cursor_;
    ReadContext& context_;
    PolygonSoup soup_;
    long long vertexCount_ = 0;
    long long faceCount_ = 0;
    bool hasNormals_ = false;
};

} // namespace

Result<PolygonSoup> readOff(std::string_view text, ReadContext& context)
{
    return OffReader(text, context).read();
}

} // namespace reflectance
