#include "app/explorer/light_handles.h"

#include "app/explorer/ui/light_angles.h"
#include "core/sensor/sensor.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace reflectance::explorer {
namespace {

constexpr float discRadius = 9.0F, ringRadius = 13.0F, glowRadius = 30.0F;

/// The light's hue at full brightness, so that a dim light is still a light.
ImVec4 hueOf(const Light& light)
{
    const double largest = std::max({light.intensity.x, light.intensity.y, light.intensity.z});
    if (!(largest > 0.0) || !std::isfinite(largest))
        return {0.5F, 0.5F, 0.5F, 1.0F};
    const auto channel = [largest](double c) { return static_cast<float>(encodeSrgb(std::max(0.0, c) / largest)); };
    return {channel(light.intensity.x), channel(light.intensity.y), channel(light.intensity.z), 1.0F};
}

ImU32 faded(const ImVec4& color, float alpha)
{
    return ImGui::ColorConvertFloat4ToU32({color.x, color.y, color.z, alpha});
}

struct Style {
    ImVec2 centre;
    ImVec4 hue;
    float strength; ///< 1 in front, less behind the object, less still when off
    float scale;
};

/// A halo that fades outwards: rings of equal alpha over one another.
void drawGlow(ImDrawList& canvas, const Style& style)
{
    constexpr int rings = 10;
    for (int i = rings; i > 0; --i) {
        const float share = static_cast<float>(i) / rings;
        const float radius = (discRadius + (glowRadius - discRadius) * share) * style.scale;
        canvas.AddCircleFilled(style.centre, radius, faded(style.hue, 0.035F * style.strength), 40);
    }
}

/// From the handle towards its sphere's centre, fading out on the way.
void drawRay(ImDrawList& canvas, const Style& style, ImVec2 towards)
{
    constexpr int pieces = 24;
    constexpr float end = 0.62F;
    const auto at = [&](float t) {
        return ImVec2(style.centre.x + (towards.x - style.centre.x) * t * end,
                      style.centre.y + (towards.y - style.centre.y) * t * end);
    };
    for (int i = 0; i < pieces; ++i) {
        const float t = static_cast<float>(i) / pieces;
        const float alpha = 0.55F * style.strength * (1.0F - t) * (1.0F - t);
        canvas.AddLine(at(t), at(t + 1.0F / pieces), faded(style.hue, alpha), 1.5F * style.scale);
    }
}

void drawDisc(ImDrawList& canvas, const Style& style, bool on, bool marked, bool selected)
{
    const float radius = (marked ? discRadius + 1.0F : discRadius) * style.scale;
    canvas.AddCircleFilled(style.centre, radius + 1.5F * style.scale, IM_COL32(0, 0, 0, 110), 32);
    if (on)
        canvas.AddCircleFilled(style.centre, radius, faded(style.hue, 0.30F + 0.70F * style.strength), 32);
    else
        canvas.AddCircle(style.centre, radius - style.scale, faded(style.hue, 0.8F), 32, 1.5F * style.scale);
    if (selected)
        canvas.AddCircle(style.centre, ringRadius * style.scale, IM_COL32(255, 255, 255, 235), 40, 2.0F * style.scale);
}

void drawNumber(ImDrawList& canvas, const Style& style, std::size_t index, bool on)
{
    const std::string number = std::to_string(index + 1);
    const float height = (number.size() > 1 ? 11.0F : 13.0F) * style.scale;
    const ImVec2 half = ImGui::GetFont()->CalcTextSizeA(height, 1e4F, 0.0F, number.c_str());
    // Black on the lit disc reads on every hue at full brightness but deep blue.
    const float luminance = 0.2126F * style.hue.x + 0.7152F * style.hue.y + 0.0722F * style.hue.z;
    const ImU32 ink = on && luminance > 0.35F ? IM_COL32(12, 12, 14, 255) : IM_COL32(245, 245, 245, 255);
    canvas.AddText(ImGui::GetFont(), height,
                   {std::round(style.centre.x - 0.5F * half.x), std::round(style.centre.y - 0.5F * half.y)}, ink,
                   number.c_str());
}

struct Drawn {
    std::size_t index;
    double depth;
};

/// Farthest first, so that nearer handles lie on top.
std::vector<Drawn> drawingOrder(const std::vector<Light>& lights, const PictureView& view, const Camera& camera)
{
    std::vector<Drawn> order;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Vec3d place = handlePoint(lights[i], camera, view.size);
        const double depth = projected(camera, place, view.size.width, view.size.height).z;
        if (depth > 0.0)
            order.push_back({i, depth});
    }
    std::sort(order.begin(), order.end(), [](const Drawn& a, const Drawn& b) { return a.depth > b.depth; });
    return order;
}

ImVec2 onScreen(const PictureView& view, double x, double y)
{
    return {view.x + static_cast<float>(x) / view.pixelsPerPoint, view.y + static_cast<float>(y) / view.pixelsPerPoint};
}

} // namespace

double handleReach(const PictureView& view)
{
    return static_cast<double>(ringRadius * view.scale * view.pixelsPerPoint);
}

void drawLightHandles(ImDrawList& canvas, const ExplorerState& state, const PictureView& view, int hovered, int held)
{
    const Camera& camera = state.scene.camera;
    const std::vector<Light> lights = shownScene(state).lights;
    for (const Drawn& drawn : drawingOrder(lights, view, camera)) {
        const Light& light = lights[drawn.index];
        const int index = static_cast<int>(drawn.index);
        const HandleView handle = viewOf(light, camera, view.size);
        const bool marked = index == hovered || index == held;
        const float strength = (light.on ? 1.0F : 0.45F) * (handle.behind && !marked ? 0.45F : 1.0F);
        const Style style{onScreen(view, handle.x, handle.y), hueOf(light), strength, view.scale};
        if (light.on)
            drawGlow(canvas, style);
        const Vec3d middle = handleSphere(light, camera, view.size).centre;
        const Vec3d centre = projected(camera, middle, view.size.width, view.size.height);
        if (light.on && centre.z > 0.0)
            drawRay(canvas, style, onScreen(view, centre.x, centre.y));
        drawDisc(canvas, style, light.on, marked, index == state.selectedLight);
        drawNumber(canvas, style, drawn.index, light.on);
    }
}

void showLightTooltip(const ExplorerState& state, int index)
{
    const Light& light = state.scene.lights[static_cast<std::size_t>(index)];
    const LightAngles angles = anglesOf(light.kind == LightKind::Directional ? light.direction : light.position);
    ImGui::BeginTooltip();
    ImGui::Text("%d  %s%s", index + 1, light.name.c_str(), light.on ? "" : " (off)");
    ImGui::Text("azimuth %.1f°  elevation %.1f°", angles.azimuth, angles.elevation);
    if (light.kind == LightKind::Point)
        ImGui::Text("point light at distance %.3g radii", length(light.position));
    ImGui::Text("I  %.3g  %.3g  %.3g", light.intensity.x, light.intensity.y, light.intensity.z);
    ImGui::EndTooltip();
}

} // namespace reflectance::explorer
