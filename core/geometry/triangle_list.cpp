#include "core/geometry/triangle_list.h"

#include "core/base/parallel.h"
#include "core/geometry/large_pages.h"
#include "core/geometry/triangle_loops.h"
#include "core/geometry/triangulate.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

/// Lengths beyond which squares overflow: such a vertex counts as infinite.
constexpr double farthest = 1e300;

constexpr std::size_t facesPerRange = 65536;

bool isFinite(const Vec3d& p)
{
    return std::fabs(p.x) < farthest && std::fabs(p.y) < farthest && std::fabs(p.z) < farthest;
}

class FaceSorter {
public:
    FaceSorter(const PolygonSoup& soup, ReadContext& context, MeshReport& report)
        : soup_(soup), context_(context), report_(report), hasNormals_(soup.namesNormals() && !soup.normalOfVertex)
    {
        list_.normalOfVertex = soup.normalOfVertex;
        list_.vertices.reserve(soup.corners.size() > 2 * soup.faceCount() ? soup.corners.size() - 2 * soup.faceCount()
                                                                          : 0);
        list_.faceNormals.reserve(list_.vertices.capacity());
        if (hasNormals_)
            list_.normals.reserve(list_.vertices.capacity());
    }

    void add(std::size_t face)
    {
        gather(face);
        if (const std::string_view reason = whyUnusable(); !reason.empty())
            drop(reason, face);
        else if (places_.size() == 3)
            addTriangle({0, 1, 2}, face);
        else
            addPolygon(face);
    }

    TriangleList take() { return std::move(list_); }

private:
    /// The places of the face's corners among all corners, neighbours that repeat a vertex left out.
    void gather(std::size_t face)
    {
        places_.clear();
        for (Index place = soup_.faceBegin(face); place < soup_.faceEnd(face); ++place)
            if (places_.empty() || soup_.corners[place] != soup_.corners[places_.back()])
                places_.push_back(place);
        while (places_.size() > 1 && soup_.corners[places_.front()] == soup_.corners[places_.back()])
            places_.pop_back();
    }

    std::string_view whyUnusable() const
    {
        for (const Index place : places_)
            if (soup_.corners[place] >= soup_.positions.size())
                return "a face uses a vertex that the file does not have";
        for (const Index place : places_)
            if (!isFinite(soup_.positions[soup_.corners[place]]))
                return "a face uses a vertex that is not a finite point";
        const bool isEdge = places_.size() < 3 || (places_.size() == 3 && vertex(0) == vertex(2));
        return isEdge ? "a face has fewer than three different corners" : "";
    }

    void drop(std::string_view reason, std::size_t face)
    {
        context_.warnings.add(reason, soup_.lineOf(face));
        const auto known = std::find_if(report_.dropped.begin(), report_.dropped.end(),
                                        [reason](const DroppedFaces& d) { return d.reason == reason; });
        if (known == report_.dropped.end())
            report_.dropped.push_back({std::string(reason), 1});
        else
            ++known->count;
    }

    void addPolygon(std::size_t face)
    {
        polygon_.clear();
        for (std::size_t i = 0; i < places_.size(); ++i)
            polygon_.push_back(soup_.positions[vertex(i)]);
        for (const auto& corners : triangulated(polygon_))
            addTriangle(corners, face);
    }

    void addTriangle(const Mesh::Triangle& corners, std::size_t face)
    {
        const Mesh::Triangle v{vertex(corners[0]), vertex(corners[1]), vertex(corners[2])};
        const Vec3d normal = faceNormal(soup_.positions[v[0]], soup_.positions[v[1]], soup_.positions[v[2]]);
        if (normal == Vec3d()) {
            ++report_.degenerateTriangles;
            context_.warnings.add("a triangle without area was left out", soup_.lineOf(face));
            return;
        }
        list_.vertices.push_back(v);
        list_.faceNormals.push_back(normal);
        if (hasNormals_)
            list_.normals.push_back({normalAt(corners[0]), normalAt(corners[1]), normalAt(corners[2])});
    }

    Index vertex(std::size_t corner) const { return soup_.corners[places_[corner]]; }
    Index normalAt(std::size_t corner) const { return soup_.normalAt(places_[corner]); }

    const PolygonSoup& soup_;
    ReadContext& context_;
    MeshReport& report_;
    bool hasNormals_;
    TriangleList list_;
    std::vector<Index> places_;
    std::vector<Vec3d> polygon_;
};

/// Copies indices, three to a triangle, and gives their memory back.
std::vector<Mesh::Triangle> inThrees(std::vector<Index>& indices, int threads)
{
    std::vector<Mesh::Triangle> triangles;
    resizeInLargePages(triangles, indices.size() / 3);
    inRanges(threads, triangles.size(), facesPerRange, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t)
            triangles[t] = {indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]};
    });
    giveBack(indices);
    return triangles;
}

/// Whether nothing more needs to be said of it than its normal.
bool isPlain(const NormalBlock& found, std::size_t i)
{
    return isHandySize(found.sizes[i]) && found.extents[i] < farthest && found.excess[i] > 0.0;
}

/// The normal of one of which more needs to be said; (0,0,0) where it cannot be drawn.
Vec3d normalIfFinite(const TriangleBlock& block, std::size_t i)
{
    const Vec3d a = block.corner(0, i);
    const Vec3d b = block.corner(1, i);
    const Vec3d c = block.corner(2, i);
    return isFinite(a) && isFinite(b) && isFinite(c) ? faceNormal(a, b, c) : Vec3d();
}

/// The way of nearly all large meshes: triangles only, every one in order. Nothing where a face is not, and then nothing
/// has been done.
std::optional<TriangleList> plainTriangles(PolygonSoup& soup, int threads)
{
    if (!soup.faceEnds.empty() || soup.corners.empty())
        return std::nullopt;
    TriangleList list;
    list.faceNormals.resize(soup.faceCount());
    std::atomic<bool> areAllPlain = true;
    const auto vertexAt = [&](std::size_t face, std::size_t k) { return soup.corners[3 * face + k]; };
    inBlocks(threads, soup.positions, soup.faceCount(), vertexAt, [&](const TriangleBlock& block) {
        if (!areAllPlain)
            return;
        NormalBlock found;
        triangleLoops().normals(block, found);
        for (std::size_t i = 0; i < block.count; ++i) {
            Vec3d& normal = list.faceNormals[block.first + i];
            normal = isPlain(found, i) ? Vec3d(found.normals[0][i], found.normals[1][i], found.normals[2][i])
                                       : normalIfFinite(block, i);
            if (normal == Vec3d())
                areAllPlain = false;
        }
    });
    if (!areAllPlain)
        return std::nullopt;
    list.normalOfVertex = soup.normalOfVertex;
    list.vertices = inThrees(soup.corners, threads);
    list.normals = inThrees(soup.cornerNormals, threads);
    return list;
}

/// Face by face, with all that may be the matter with one.
Result<TriangleList> sortedTriangles(const PolygonSoup& soup, ReadContext& context, MeshReport& report)
{
    FaceSorter sorter(soup, context, report);
    for (std::size_t face = 0; face < soup.faceCount(); ++face) {
        if (face % facesPerRange == 0 &&
            !context.goOn(static_cast<double>(face) / static_cast<double>(soup.faceCount())))
            return context.stopped();
        sorter.add(face);
    }
    return sorter.take();
}

} // namespace

Vec3d faceNormal(const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
    TriangleSides<double> sides(a, b, c);
    double size = sides.size();
    double extent = extentOf(a, b, c);
    if (!(size > 0.0))
        return {};
    if (!isHandySize(size)) { // squares of 1e-200 would vanish
        extent /= size;
        for (Vec3d* side : {&sides.ab, &sides.ac, &sides.bc})
            *side = *side / size;
        size = 1.0;
    }
    const Vec3d normal = sides.normal();
    const double sine = std::sqrt(dot(normal, normal));
    return sine > roundingOf(extent, size) ? normal / sine : Vec3d();
}

Result<TriangleList> trianglesOf(PolygonSoup& soup, ReadContext& context, MeshReport& report)
{
    report.fileVertices = soup.positions.size();
    report.fileFaces = soup.faceCount();
    auto plain = plainTriangles(soup, context.threads);
    auto list = plain ? Result<TriangleList>(*std::move(plain)) : sortedTriangles(soup, context, report);
    if (!list)
        return list;
    for (auto* indices : {&soup.corners, &soup.cornerNormals, &soup.faceEnds, &soup.faceLines})
        giveBack(*indices);
    report.triangles = list->vertices.size();
    return list;
}

} // namespace reflectance
