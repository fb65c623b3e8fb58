// Micro-surfaces from pictures of heights and from meshes.
#include "core/base/text.h"
#include "core/geometry/load.h"
#include "core/image/picture_file.h"
#include "core/sensor/sensor.h"
#include "core/study/goniometer/surface_makers.h"
#include "core/study/goniometer/tiled_rays.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

Result<std::vector<double>> heightsOf(const Picture& picture, double scale, const std::string& path)
{
    std::vector<double> heights;
    for (int y = picture.image.height; y-- > 0;) // rows of a picture go down, y goes up
        for (int x = 0; x < picture.image.width; ++x) {
            const float* rgb = picture.image.at(x, y);
            double height = (double{rgb[0]} + rgb[1] + rgb[2]) / 3.0;
            if (!std::isfinite(height))
                return Error{"the height at column " + std::to_string(x) + ", row " + std::to_string(y) +
                                 " is no number; repair that pixel",
                             path};
            // Files of code values are read as light; a height is the code value itself.
            heights.push_back(scale * (picture.isLinear() ? height : encodeSrgb(height)));
        }
    return heights;
}

struct Size {
    std::size_t columns, rows;
};

Result<Size> checkedSize(const Image& image, bool mirrored, const std::string& path)
{
    const std::size_t heights = image.pixels() * (mirrored ? 4 : 1);
    if (image.width < 2 || image.height < 2)
        return Error{"a picture of heights needs at least 2 x 2 pixels", path};
    if (heights > mostHeights)
        return Error{"makes " + general(static_cast<double>(heights), 4) + " heights" + (mirrored ? " mirrored" : "") +
                         "; " + std::to_string(mostHeights) + " are possible; scale the picture down",
                     path};
    return Size{static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height)};
}

/// Samples stand in the middle of pixels, so mirrored neighbours repeat the outermost pixel: no step, no cliff.
std::vector<double> mirroredHeights(const std::vector<double>& heights, Size& size)
{
    std::vector<double> all;
    for (std::size_t y = 0; y < 2 * size.rows; ++y)
        for (std::size_t x = 0; x < 2 * size.columns; ++x)
            all.push_back(heights[(y < size.rows ? y : 2 * size.rows - 1 - y) * size.columns +
                                  (x < size.columns ? x : 2 * size.columns - 1 - x)]);
    size = {2 * size.columns, 2 * size.rows};
    return all;
}

/// The mesh's coordinates with its height along z, its corner at the origin, its longer side 1.
Result<Patch> lying(const Mesh& mesh, const std::string& up, const std::string& path)
{
    Vec3d low = mesh.positions.front();
    Vec3d high = low;
    for (const Vec3d& p : mesh.positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3d size = high - low;
    const char axis = !up.empty() ? up.front() : size.x < std::min(size.y, size.z) ? 'x' : size.y < size.z ? 'y' : 'z';
    const auto turned = [axis](const Vec3d& v) { // cyclic, so that no hand is exchanged
        return axis == 'x' ? Vec3d{v.y, v.z, v.x} : axis == 'y' ? Vec3d{v.z, v.x, v.y} : v;
    };
    const Vec3d extent = turned(size);
    const double scale = 1.0 / std::max(extent.x, extent.y);
    if (!std::isfinite(scale) || !(std::min(extent.x, extent.y) > 0.0))
        return Error{"has no area when seen along " + std::string(1, axis) + "; choose another up=", path};
    Patch patch{scale * extent.x, scale * extent.y, {}, mesh.triangles};
    for (const Vec3d& p : mesh.positions)
        patch.positions.push_back(scale * (turned(p) - turned(low)));
    return patch;
}

/// Every point of the rectangle must show an outer side from above: else rays fall through, or see the inside of a body.
Result<void> checkCovers(const Patch& patch, const std::string& path)
{
    constexpr int side = 64;
    const TiledRays rays(patch);
    std::vector<TiledRay> down;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            down.push_back(
                {{(x + 0.5) / side * rays.width(), (y + 0.5) / side * rays.depth(), rays.top()}, {0, 0, -1}});
    rays.trace(down);
    const auto open =
        std::count_if(down.begin(), down.end(), [](const TiledRay& ray) { return ray.end != TiledRay::End::Facet; });
    if (open > 0)
        return Error{"is no patch of a surface: seen from above it leaves " +
                         general(100.0 * static_cast<double>(open) / (side * side), 3) +
                         " % of its bounding rectangle open; cut a rectangle out of it",
                     path};
    return {};
}

} // namespace

Result<std::vector<Patch>> patchesFromPicture(const std::string& path, std::string_view text)
{
    const auto words = SurfaceWords::parsed(text, {"height", "tile"});
    if (!words)
        return words.error();
    const std::string tile = words->word("tile", "mirror");
    if (tile != "mirror" && tile != "wrap")
        return Error{"tile = " + tile + " is neither mirror nor wrap"};
    if (!words->has("height"))
        return Error{"its heights need a scale; add :height=H, where H, in longer sides of the picture, is what value "
                     "1 stands for"};
    const auto scale = words->number("height", 0.0, 1e-9, 1e3);
    if (!scale)
        return scale.error();
    const auto picture = readPicture(path);
    if (!picture)
        return picture.error();
    auto size = checkedSize(picture->image, tile == "mirror", path);
    if (!size)
        return size.error();
    const double longer = static_cast<double>(std::max(size->columns, size->rows));
    auto heights = heightsOf(*picture, *scale * (tile == "mirror" ? 0.5 : 1.0), path);
    if (!heights)
        return heights.error();
    const auto [low, high] = std::minmax_element(heights->begin(), heights->end());
    if (*low == *high)
        return Error{"every height is the same; for a plane write flat", path};
    const double width = static_cast<double>(size->columns) / longer;
    const double depth = static_cast<double>(size->rows) / longer;
    if (tile == "mirror")
        heights = mirroredHeights(*heights, *size);
    return std::vector{heightField(size->columns, size->rows, *heights, width, depth)};
}

Result<std::vector<Patch>> patchesFromMesh(const std::string& path, std::string_view text)
{
    const auto words = SurfaceWords::parsed(text, {"up"});
    if (!words)
        return words.error();
    const std::string up = words->word("up", "");
    if (!up.empty() && up != "x" && up != "y" && up != "z")
        return Error{"up = " + up + " is none of x, y and z"};
    const auto loaded = loadStockOrFile(path);
    if (!loaded)
        return loaded.error().file.empty() ? Error{loaded.error().message, path} : loaded.error();
    if (4 * loaded->mesh->triangles.size() > 2 * mostHeights)
        return Error{"has " + std::to_string(loaded->mesh->triangles.size()) + " triangles; " +
                         std::to_string(mostHeights / 2) + " are possible; cut a smaller patch out of it",
                     path};
    const auto patch = lying(*loaded->mesh, up, path);
    if (!patch)
        return patch.error();
    if (const auto covers = checkCovers(*patch, path); !covers)
        return covers.error();
    return std::vector{mirroredTile(*patch)};
}

} // namespace reflectance
