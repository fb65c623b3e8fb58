#include "core/geometry/ply_blocks.h"

#include "core/base/parallel.h"
#include "core/geometry/large_pages.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

constexpr std::size_t perRange = 65536;

/// Where three numbers of the same type stand within an element.
struct Triple {
    std::array<std::size_t, 3> offsets{};
    bool isDouble = false;
    bool isThere = false;

    Triple(const PlyElement& element, const std::array<std::string_view, 3>& names)
    {
        std::array<const PlyProperty*, 3> found{};
        std::size_t offset = 0;
        for (const PlyProperty& property : element.properties) {
            const auto place =
                static_cast<std::size_t>(std::find(names.begin(), names.end(), property.name) - names.begin());
            if (place < found.size()) {
                found[place] = &property;
                offsets[place] = offset;
            }
            offset += sizeOf(property.type);
        }
        const auto areAll = [&](PlyType type) {
            return std::all_of(found.begin(), found.end(),
                               [type](const PlyProperty* p) { return p && p->type == type; });
        };
        isDouble = areAll(PlyType::Float64);
        isThere = isDouble || areAll(PlyType::Float32);
    }

    [[nodiscard]] Vec3d at(const char* element) const
    {
        return isDouble ? numbers<double>(element) : numbers<float>(element);
    }

private:
    template <class Number> [[nodiscard]] Vec3d numbers(const char* element) const
    {
        std::array<Number, 3> v;
        for (std::size_t k = 0; k < v.size(); ++k)
            std::memcpy(&v[k], element + offsets[k], sizeof(Number));
        return Vec3d(Vec3<Number>(v[0], v[1], v[2]));
    }
};

/// Of every element in bytes; 0 where it is not the same for all, or where `bytes` does not hold all of them.
std::size_t strideOf(const PlyElement& element, std::string_view bytes)
{
    std::size_t stride = 0;
    for (const PlyProperty& property : element.properties)
        stride = property.countType ? bytes.size() + 1 : stride + sizeOf(property.type);
    return stride > 0 && element.count <= bytes.size() / stride ? stride : 0;
}

bool names(const PlyElement& element, std::string_view property)
{
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [property](const PlyProperty& p) { return p.name == property; });
}

void readTriples(const Triple& triple, const char* first, std::size_t stride, int threads, std::span<Vec3d> vectors)
{
    inRanges(threads, vectors.size(), perRange, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            vectors[i] = triple.at(first + i * stride);
    });
}

/// Makes room for the element's vectors behind those that are there.
std::span<Vec3d> roomFor(const PlyElement& element, std::vector<Vec3d>& vectors)
{
    resizeInLargePages(vectors, vectors.size() + element.count);
    return std::span(vectors).last(element.count);
}

bool isTriangle(const PlyElement& element)
{
    if (element.properties.size() != 1)
        return false;
    const PlyProperty& list = element.properties[0];
    return (list.countType == PlyType::Uint8 || list.countType == PlyType::Int8) &&
           (list.type == PlyType::Int32 || list.type == PlyType::Uint32) &&
           (list.name == "vertex_indices" || list.name == "vertex_index");
}

} // namespace

std::size_t readVertexBlock(const PlyElement& element, std::string_view bytes, int threads, PolygonSoup& soup)
{
    const std::size_t stride = strideOf(element, bytes);
    const Triple positions(element, {"x", "y", "z"});
    const Triple normals(element, {"nx", "ny", "nz"});
    if (stride == 0 || !positions.isThere || (names(element, "nz") && !normals.isThere))
        return 0;
    readTriples(positions, bytes.data(), stride, threads, roomFor(element, soup.positions));
    if (normals.isThere)
        readTriples(normals, bytes.data(), stride, threads, roomFor(element, soup.normals));
    return element.count * stride;
}

std::size_t readTriangleBlock(const PlyElement& element, std::string_view bytes, int threads, PolygonSoup& soup)
{
    constexpr std::size_t stride = 1 + 3 * sizeof(Index);
    if (!isTriangle(element) || element.count > bytes.size() / stride || !soup.faceEnds.empty())
        return 0;
    const std::size_t before = soup.corners.size();
    resizeInLargePages(soup.corners, before + 3 * element.count);
    std::atomic<bool> areTriangles = true;
    inRanges(threads, element.count, perRange, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && areTriangles; ++i) {
            const char* const face = bytes.data() + i * stride;
            if (*face != 3)
                areTriangles = false;
            std::memcpy(&soup.corners[before + 3 * i], face + 1, 3 * sizeof(Index));
        }
    });
    if (areTriangles)
        return element.count * stride;
    soup.corners.resize(before);
    return 0;
}

} // namespace reflectance
