// The picture of a scene or of its two variants, ready to be saved: what the window shows and what `render` makes of the
// same recipe are put together here.
#pragma once

#include "app/explorer/difference.h"
#include "core/base/result.h"
#include "core/image/image.h"
#include "core/scene/kept_picture.h"
#include "core/sensor/sensor.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// Whether both variants are in the picture.
[[nodiscard]] inline bool showsBoth(VariantView shown)
{
    return shown != VariantView::A && shown != VariantView::B;
}

/// Of A's and B's pictures in a side by side of that width; what is left is the gap between them, 2 or 3 pixels.
[[nodiscard]] int paneWidth(int wholeWidth);
[[nodiscard]] int wholeWidth(int paneWidth); ///< the narrowest with such panes

struct ShownPicture {
    Image linear; ///< empty for a map of the difference, which has none
    Developed codes;
    std::optional<DifferenceFigures> difference = {}; ///< of a map of the difference
};

/// Renders one variant in the given width and height.
using RenderVariant = std::function<Result<Image>(const Scene& scene, int width, int height)>;

/// Renders what the recipe asks for. A scene without B can show A only.
[[nodiscard]] Result<ShownPicture> shownPicture(const Scene& scene, const PictureRecipe& recipe,
                                                const RenderVariant& render);

/// Writes it by the name's ending, with all that makes it again. A map of the difference can only be a PNG.
[[nodiscard]] Result<void> saveShown(const std::string& path, const ShownPicture& picture, const Scene& scene,
                                     const PictureRecipe& recipe);

/// The notes of a picture that goes to this file.
[[nodiscard]] Notes notesFor(const std::string& path, const Scene& scene, const PictureRecipe& recipe);

} // namespace reflectance::explorer
