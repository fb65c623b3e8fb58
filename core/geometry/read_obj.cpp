// Reads an OBJ file in parts, on several threads, and puts them together in their order: the result is that of one
// thread, to the warnings and their lines.
#include "core/base/parallel.h"
#include "core/geometry/large_pages.h"
#include "core/geometry/obj_part.h"
#include "core/geometry/readers.h"

#include <algorithm>
#include <optional>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

template <class T> void append(std::vector<T>& all, const std::vector<T>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

/// Takes over part after part.
class ObjSoup {
public:
    /// Room for a file of this many bytes, generously: memory that stays untouched costs nothing, moving it does.
    void expect(std::uintmax_t bytes)
    {
        constexpr std::uintmax_t fewest = 1U << 20U;
        if (bytes < fewest)
            return;
        reserveInLargePages(soup_.positions, static_cast<std::size_t>(bytes / 32));
        reserveInLargePages(soup_.corners, static_cast<std::size_t>(bytes / 10));
        reserveInLargePages(soup_.faceLines, static_cast<std::size_t>(bytes / 30));
    }

    void add(const ObjPart& part, Warnings& warnings)
    {
        addNormalIndices(part);
        addFaceEnds(part);
        const std::size_t before = soup_.corners.size();
        append(soup_.corners, part.corners);
        for (const RelativeIndex& relative : part.relativeCorners)
            soup_.corners[before + relative.corner] = resolved(relative, soup_.positions.size());
        append(soup_.positions, part.positions);
        append(soup_.normals, part.normals);
        for (const Index line : part.faceLines)
            soup_.faceLines.push_back(line + static_cast<Index>(lines_));
        warnings.append(part.warnings, lines_);
        lines_ += part.lines;
        hasMaterials_ = hasMaterials_ || part.hasMaterials;
    }

    PolygonSoup take()
    {
        soup_.format = "OBJ";
        if (hasMaterials_)
            soup_.notes.emplace_back("materials (mtllib, usemtl) are not read: the surface is this program's own");
        return std::move(soup_);
    }

private:
    static Index resolved(const RelativeIndex& relative, std::size_t before)
    {
        const long long index = static_cast<long long>(before) + relative.fromPartZero;
        return index < 0 || index >= static_cast<long long>(PolygonSoup::none) ? PolygonSoup::none
                                                                               : static_cast<Index>(index);
    }

    /// Most files give every vertex its own normal, `f 1//1 2//2 3//3`: then no second list of indices is kept.
    void addNormalIndices(const ObjPart& part)
    {
        if (part.corners.empty())
            return;
        const bool namesNone = part.cornerNormals.empty();
        const bool isSame = part.relativeNormals.empty() && part.relativeCorners.empty() && !namesNone &&
                            part.cornerNormals == part.corners;
        if (isSame && (soup_.normalOfVertex || soup_.corners.empty())) {
            soup_.normalOfVertex = true;
            return;
        }
        if (namesNone && !soup_.namesNormals())
            return;
        if (std::exchange(soup_.normalOfVertex, false))
            soup_.cornerNormals = soup_.corners;
        const std::size_t before = soup_.corners.size();
        soup_.cornerNormals.resize(before, PolygonSoup::none);
        append(soup_.cornerNormals, part.cornerNormals);
        soup_.cornerNormals.resize(before + part.corners.size(), PolygonSoup::none);
        for (const RelativeIndex& relative : part.relativeNormals)
            soup_.cornerNormals[before + relative.corner] = resolved(relative, soup_.normals.size());
    }

    /// Ends of faces are kept from the first face on that is no triangle.
    void addFaceEnds(const ObjPart& part)
    {
        if (part.faceLines.empty() || (part.faceEnds.empty() && soup_.faceEnds.empty()))
            return;
        if (soup_.faceEnds.empty())
            for (std::size_t face = 0; face < soup_.faceLines.size(); ++face)
                soup_.faceEnds.push_back(static_cast<Index>(3 * face + 3));
        const auto before = static_cast<Index>(soup_.corners.size());
        for (std::size_t face = 0; face < part.faceLines.size(); ++face)
            soup_.faceEnds.push_back(before +
                                     (part.faceEnds.empty() ? static_cast<Index>(3 * face + 3) : part.faceEnds[face]));
    }

    PolygonSoup soup_;
    long lines_ = 0;
    bool hasMaterials_ = false;
};

struct Item {
    TextParts::Buffer buffer;
    std::string_view text;
    ObjPart part;
};

} // namespace

Result<PolygonSoup> readObj(TextParts text, ReadContext& context)
{
    ObjSoup soup;
    soup.expect(text.size());
    std::optional<Error> failure;
    double done = 0.0;
    const auto take = [&](Item& item) {
        const auto next = text.next(item.buffer);
        if (!next)
            failure = next.error();
        item.text = next ? *next : std::string_view();
        return !item.text.empty();
    };
    const auto work = [](Item& item) {
        item.part.clear();
        readObjPart(item.text, item.part);
    };
    const auto give = [&](const Item& item) {
        if (!context.goOn(done / static_cast<double>(text.size())))
            return false;
        done += static_cast<double>(item.text.size());
        soup.add(item.part, context.warnings);
        return true;
    };
    const auto threads = std::min(text.parts(), static_cast<std::uintmax_t>(context.threads));
    inOrder<Item>(static_cast<int>(threads), take, work, give);
    if (context.isCancelled())
        return context.stopped();
    if (failure)
        return *failure;
    return soup.take();
}

} // namespace reflectance
