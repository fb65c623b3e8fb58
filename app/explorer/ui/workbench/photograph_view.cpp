#include "app/explorer/ui/workbench/photograph_view.h"

#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

namespace {

constexpr float markRadius = 5.0F;

/// Where the picture lies in the window.
struct Placed {
    ImVec2 topLeft;
    float scale = 1.0F; ///< window pixels per pixel of the picture

    [[nodiscard]] ImVec2 centreOf(PixelPlace pixel) const
    {
        return {topLeft.x + (static_cast<float>(pixel.x) + 0.5F) * scale,
                topLeft.y + (static_cast<float>(pixel.y) + 0.5F) * scale};
    }
};

PixelPlace pixelAt(const Placed& placed, const Developed& shown, ImVec2 mouse)
{
    const auto index = [&](float at, int count) {
        return std::clamp(static_cast<int>(std::floor(at / placed.scale)), 0, count - 1);
    };
    return {index(mouse.x - placed.topLeft.x, shown.width), index(mouse.y - placed.topLeft.y, shown.height)};
}

void toggle(std::vector<PixelPlace>& pixels, const Placed& placed, PixelPlace pixel)
{
    const ImVec2 at = placed.centreOf(pixel);
    const auto hit = std::find_if(pixels.begin(), pixels.end(), [&](PixelPlace p) {
        const ImVec2 mark = placed.centreOf(p);
        return std::hypot(mark.x - at.x, mark.y - at.y) <= points(markRadius);
    });
    if (hit == pixels.end())
        pixels.push_back(pixel);
    else
        pixels.erase(hit);
}

void drawMarks(const std::vector<PixelPlace>& pixels, const Placed& placed)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const PixelPlace pixel : pixels) {
        const ImVec2 at = placed.centreOf(pixel);
        list.AddCircle(at, points(markRadius), IM_COL32_BLACK, 0, points(3));
        list.AddCircle(at, points(markRadius), palette::accent, 0, points(1.5F));
    }
}

std::string readingOf(const Image& image, PixelPlace pixel)
{
    const float* const rgb = image.at(pixel.x, pixel.y);
    std::string text = "pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) + ", linear";
    for (int k = 0; k < 3; ++k)
        text += " " + general(static_cast<double>(rgb[k]), 3);
    return text + ". Click marks it, or takes its mark away.";
}

} // namespace

void drawPhotograph(FitStudy& study, ImVec2 size)
{
    const std::shared_ptr<const Photograph> photograph = study.wish.photograph;
    if (!photograph)
        return remark(
            "Name a picture of this object, seen by this camera under these lights: a photograph, or a render saved "
            "before. All its pixels are fitted, or those that you click.");
    if (!photograph->problem.empty())
        return remark(photograph->problem, palette::error, Face::Body);
    const Developed& shown = photograph->shown;
    const float scale = std::min(size.x / static_cast<float>(shown.width), size.y / static_cast<float>(shown.height));
    const ImVec2 drawn{std::max(1.0F, scale * static_cast<float>(shown.width)),
                       std::max(1.0F, scale * static_cast<float>(shown.height))};
    const Placed placed{ImGui::GetCursorScreenPos(), scale};
    const bool clicked = ImGui::InvisibleButton("photograph", drawn);
    const PixelPlace under = pixelAt(placed, shown, ImGui::GetIO().MousePos);
    tooltip(readingOf(photograph->picture.image, under));
    if (clicked && ImGui::IsItemHovered())
        toggle(study.wish.pixels, placed, under);
    const ImVec2 corner{placed.topLeft.x + drawn.x, placed.topLeft.y + drawn.y};
    ImGui::GetWindowDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(study.pictureTexture)), placed.topLeft, corner);
    drawMarks(study.wish.pixels, placed);
}

} // namespace reflectance::explorer
