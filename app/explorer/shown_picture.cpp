#include "app/explorer/shown_picture.h"

#include "core/image/beside.h"
#include "core/image/picture_file.h"
#include "core/sensor/picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace reflectance::explorer {
namespace {

constexpr int narrowestGap = 2;

Result<ShownPicture> mapOf(const Image& a, const Image& b, const Sensor& sensor)
{
    Progress unwatched;
    std::optional<DifferencePicture> map = differenceOf(a, b, std::log2(gainOf(sensor)), false, unwatched);
    if (!map)
        return Error{"the pictures of A and B do not compare"};
    ShownPicture picture;
    picture.codes.width = map->width;
    picture.codes.height = map->height;
    picture.codes.rgb = std::move(map->rgb);
    picture.difference = map->figures;
    return picture;
}

Image together(const Image& a, const Image& b, const PictureRecipe& recipe)
{
    if (recipe.shown == VariantView::Wipe)
        return wiped(a, b, recipe.divider);
    return sideBySide(a, b, recipe.width - 2 * a.width);
}

ShownPicture developed(Image linear, const Sensor& sensor)
{
    Developed codes = develop(linear, sensor);
    return {std::move(linear), std::move(codes)};
}

} // namespace

int paneWidth(int whole)
{
    return std::max(1, (whole - narrowestGap) / 2);
}

int wholeWidth(int pane)
{
    return 2 * pane + narrowestGap;
}

Result<ShownPicture> shownPicture(const Scene& scene, const PictureRecipe& recipe, const RenderVariant& render)
{
    if (recipe.shown != VariantView::A && !scene.other)
        return Error{"the scene has one surface only; give it another one, 'compare', to see B"};
    const int width = recipe.shown == VariantView::SideBySide ? paneWidth(recipe.width) : recipe.width;
    if (recipe.shown == VariantView::SideBySide && recipe.width < narrowestGap + 2)
        return Error{"side by side needs at least four pixels of width"};
    auto one = render(recipe.shown == VariantView::B ? variantB(scene) : scene, width, recipe.height);
    if (!one)
        return one.error();
    if (recipe.shown == VariantView::A || recipe.shown == VariantView::B)
        return developed(*std::move(one), scene.sensor);
    const auto b = render(variantB(scene), width, recipe.height);
    if (!b)
        return b.error();
    return recipe.shown == VariantView::Difference ? mapOf(*one, *b, scene.sensor)
                                                   : developed(together(*one, *b, recipe), scene.sensor);
}

Notes notesFor(const std::string& path, const Scene& scene, const PictureRecipe& recipe)
{
    return keptNotes(scene, recipe, std::filesystem::path(path).parent_path().string());
}

/// A map has codes of its own, which no sensor made.
static Result<void> writeCodes(const std::string& path, const ShownPicture& picture, const Sensor& sensor,
                               const Notes& notes)
{
    const Developed& codes = picture.codes;
    const PngColor color = picture.linear.rgb.empty() ? PngColor() : pngColorOf(sensor);
    return codes.deep.empty() ? writePng(path, codes.width, codes.height, codes.rgb, color, notes)
                              : writePng(path, codes.width, codes.height, codes.deep, color, notes);
}

Result<void> saveShown(const std::string& path, const ShownPicture& picture, const Scene& scene,
                       const PictureRecipe& recipe)
{
    const auto format = outputFormat(path);
    if (!format)
        return format.error();
    const Notes notes = notesFor(path, scene, recipe);
    if (*format == PictureFormat::Png)
        return writeCodes(path, picture, scene.sensor, notes);
    if (picture.linear.rgb.empty())
        return Error{"a map of the difference is no linear picture; end the name in .png", path};
    return writeLinear(path, picture.linear, notes);
}

} // namespace reflectance::explorer
