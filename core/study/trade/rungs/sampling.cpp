// Shading place, samples and resolution: how often the model is asked, and for how many pixels.
#include "core/study/trade/rungs/rungs.h"

namespace reflectance::rung {

namespace {

/// Samples that a recipe may keep: at 56 bytes each, half a gibibyte where the object fills the picture.
constexpr long mostSamples = 1L << 23;

} // namespace

Applied shadedAt(int place, Recipe& recipe)
{
    const bool inPixels = static_cast<Place>(place) == Place::Pixel || static_cast<Place>(place) == Place::Fragment;
    if (inPixels && recipe.settings.samplesPerAxis == 1)
        return {"one sample per pixel is shaded once already"};
    recipe.place = static_cast<Place>(place);
    return {};
}

Applied bodyPerVertex(int /*amount*/, Recipe& recipe)
{
    if (modelOf(recipe.scene).id() != "hybrid")
        return {modelOf(recipe.scene).text.name + " has no highlight to keep per sample"};
    recipe.place = Place::Vertex;
    recipe.lobePerSample = true;
    return {};
}

Applied samplesPerAxis(int k, Recipe& recipe)
{
    const std::string count = std::to_string(k * k);
    if (recipe.settings.samplesPerAxis == k)
        return {"the picture has " + count + (k == 1 ? " sample" : " samples") + " per pixel already"};
    if (static_cast<long>(recipe.settings.width) * recipe.settings.height * k * k > mostSamples)
        return {count + " samples per pixel of this size would have to be kept in more than half a gibibyte"};
    recipe.settings.samplesPerAxis = k;
    return {};
}

Applied reducedBy(int factor, Recipe& recipe)
{
    constexpr int smallest = 8; // pixels along an edge that still show something
    if (recipe.settings.width < smallest * factor || recipe.settings.height < smallest * factor)
        return {"the picture is too small to be reduced by " + std::to_string(factor)};
    recipe.reduction = factor;
    return {};
}

} // namespace reflectance::rung
