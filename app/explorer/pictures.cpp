#include "app/explorer/pictures.h"

#include "app/explorer/shown_picture.h"
#include "app/explorer/user_folders.h"
#include "app/explorer/viewed_scene.h"
#include "core/base/text.h"
#include "core/image/picture_file.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace reflectance::explorer {
namespace {

std::string chosenPath(const ExplorerState& state, const std::string& path)
{
    if (!path.empty())
        return path;
    return freeName(picturesFolder(), state.scene.mesh->name, state.scene.surface.model, ".png").string();
}

/// The current framebuffer, rows from the top.
std::vector<std::uint8_t> readFramebuffer(ViewSize size, GetProcAddress load)
{
    const auto pixelStorei = reinterpret_cast<PFNGLPIXELSTOREIPROC>(load("glPixelStorei"));
    const auto readPixels = reinterpret_cast<PFNGLREADPIXELSPROC>(load("glReadPixels"));
    const auto rowBytes = 3 * static_cast<std::ptrdiff_t>(size.width);
    std::vector<std::uint8_t> rgb(static_cast<std::size_t>(rowBytes) * static_cast<std::size_t>(size.height));
    pixelStorei(GL_PACK_ALIGNMENT, 1);
    readPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    for (auto low = rgb.begin(), high = rgb.end() - rowBytes; low < high; low += rowBytes, high -= rowBytes)
        std::swap_ranges(low, low + rowBytes, high);
    return rgb;
}

VariantView shownOf(const CompareView& compare)
{
    if (!compare.on)
        return VariantView::A;
    switch (compare.mode) {
    case CompareMode::SideBySide:
        return VariantView::SideBySide;
    case CompareMode::Wipe:
        return VariantView::Wipe;
    case CompareMode::Flip:
        break;
    case CompareMode::Difference:
        return VariantView::Difference;
    }
    return compare.handOnB ? VariantView::B : VariantView::A;
}

PictureRecipe recipeOf(const ExplorerState& state, const Viewport& viewport)
{
    const ViewSize size = viewport.view.size;
    PictureRecipe recipe{size.width, size.height, state.preferences.samplesPerAxis};
    recipe.shown = shownOf(state.compare);
    if (recipe.shown == VariantView::SideBySide)
        recipe.width = wholeWidth(size.width);
    recipe.divider = static_cast<double>(state.compare.divider);
    recipe.holes = true;
    if (seesTermAlone(state))
        recipe.term = state.probe.term;
    return recipe;
}

/// Beside a picture of GL's the CPU shades what GL saw, as in the window and in `render`.
Result<Image> byRungs(const Scene& viewed, const Scene& variant, const RenderSettings& settings, bool pair,
                      GlRenderer& renderer)
{
    const bool isA = variant.surface == viewed.surface;
    const bool besideGl = pair && viewed.other && drawnByGl((isA ? *viewed.other : viewed.surface).rungs, true);
    std::shared_ptr<const ViewSamples> seen;
    if (besideGl && !drawnByGl(variant.surface.rungs, true)) {
        if (const Result<void> looked = renderer.render(variant, settings); !looked)
            return looked.error();
        seen = std::make_shared<const ViewSamples>(renderer.readSamples());
    }
    return pictureByRungs(variant, settings, renderer, seen);
}

/// Rows `top` .. of a picture that is `width` wide.
std::vector<std::uint8_t> cutOut(const std::vector<std::uint8_t>& rgb, int width, int left, int top, int wide, int high)
{
    std::vector<std::uint8_t> part;
    for (int y = top; y < top + high; ++y) {
        const auto begin = rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * width + left);
        part.insert(part.end(), begin, begin + 3 * static_cast<std::ptrdiff_t>(wide));
    }
    return part;
}

} // namespace

std::optional<WindowRegion> regionFrom(const std::string& name, const std::string& text)
{
    std::vector<float> numbers;
    for (const std::string_view word : words(text))
        if (const auto number = parseNumber(word))
            numbers.push_back(static_cast<float>(*number));
    if (numbers.size() != 4 || !(numbers[2] >= 1.0F) || !(numbers[3] >= 1.0F))
        return std::nullopt;
    return WindowRegion{name, numbers[0], numbers[1], numbers[2], numbers[3]};
}

Result<std::string> saveRegionPicture(const ExplorerState& state, const WindowRegion& region, ViewSize framebuffer,
                                      float scale, GetProcAddress load)
{
    const auto within = [scale](float at, int most) {
        return std::clamp(static_cast<int>(std::lround(at * scale)), 0, most);
    };
    const int left = within(region.left, framebuffer.width),
              right = within(region.left + region.width, framebuffer.width);
    const int top = within(region.top, framebuffer.height),
              bottom = within(region.top + region.height, framebuffer.height);
    if (right <= left || bottom <= top)
        return Error{"the plot is no longer in the window; open it and save it again"};
    const std::vector<std::uint8_t> rgb =
        cutOut(readFramebuffer(framebuffer, load), framebuffer.width, left, top, right - left, bottom - top);
    const std::filesystem::path name = region.name;
    const std::string path =
        freeName(picturesFolder(), state.scene.mesh->name, name.stem().string(), name.extension().string()).string();
    if (const Result<void> written = writePng(path, right - left, bottom - top, rgb, {}, {}); !written)
        return written.error();
    return path;
}

Result<std::string> saveViewPicture(const ExplorerState& state, const Viewport& viewport, GlRenderer& renderer,
                                    SecondView& second, const std::string& path)
{
    const Scene scene = shownScene(state);
    const Scene viewed = viewedScene(state);
    const PictureRecipe recipe = recipeOf(state, viewport);
    const auto render = [&](const Scene& variant, int width, int height) -> Result<Image> {
        const RenderSettings settings{width, height, recipe.samplesPerAxis};
        if (!variant.surface.rungs.empty())
            return byRungs(viewed, variant, settings, showsBoth(recipe.shown), renderer);
        const bool isB = recipe.shown != VariantView::A && !variant.other; // each has its own buffers
        if (const Result<void> drawn = isB ? second.renderB(variant, settings) : renderer.render(variant, settings);
            !drawn)
            return drawn.error();
        return isB ? second.renderer->readLinear() : renderer.readLinear();
    };
    const auto picture = shownPicture(viewed, recipe, render);
    if (!picture)
        return picture.error();
    const std::string chosen = chosenPath(state, path);
    if (const Result<void> written = saveShown(chosen, *picture, scene, recipe); !written)
        return written.error();
    return chosen;
}

Result<std::string> saveWindowPicture(const ExplorerState& state, const Viewport& viewport, ViewSize size,
                                      GetProcAddress load, const std::string& path)
{
    const std::vector<std::uint8_t> rgb = readFramebuffer(size, load);
    const std::string chosen = chosenPath(state, path);
    const Notes notes = notesFor(chosen, shownScene(state), recipeOf(state, viewport));
    if (const Result<void> written = writePng(chosen, size.width, size.height, rgb, {}, notes); !written)
        return written.error();
    return chosen;
}

} // namespace reflectance::explorer
