#include "app/explorer/ui/light_list.h"

#include "app/explorer/ui/light_angles.h"
#include "app/explorer/ui/row_list.h"
#include "app/explorer/ui/widgets.h"
#include "core/scene/names.h"
#include "core/sensor/sensor.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

namespace {

void drawSwatch(const Light& light, ImVec2 topLeft, float side)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 centre{topLeft.x + side / 2, topLeft.y + side / 2};
    if (light.on)
        list.AddCircleFilled(centre, side / 2, ImGui::GetColorU32(swatchColor(light)));
    else
        list.AddCircle(centre, side / 2 - 1, ImGui::GetColorU32(palette::quiet), 0, points(1.5F));
}

/// A round switch that shows the light's colour while it is on.
void drawSwitch(Light& light)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    if (ImGui::InvisibleButton("on", {height, height}))
        light.on = !light.on;
    tooltip(light.on ? "Switch this light off." : "Switch this light on.");
    const float side = points(14);
    if (ImGui::IsItemHovered())
        ImGui::GetWindowDrawList()->AddCircle({start.x + height / 2, start.y + height / 2}, side / 2 + points(3),
                                              ImGui::GetColorU32(palette::accent));
    drawSwatch(light, {start.x + (height - side) / 2, start.y + (height - side) / 2}, side);
}

void drawName(ExplorerState& state, int index, float width)
{
    const Light& light = state.scene.lights[static_cast<std::size_t>(index)];
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    if (ImGui::InvisibleButton("select", {width, height}))
        state.selectedLight = index;
    if (state.selectedLight == index || ImGui::IsItemHovered())
        ImGui::GetWindowDrawList()->AddRectFilled(
            start, {start.x + width, start.y + height},
            ImGui::GetColorU32(state.selectedLight == index ? palette::chosen : palette::raised),
            ImGui::GetStyle().FrameRounding);
    tooltip("Select " + light.name + ": its controls are below, its handle in the view is highlighted.");
    const bool shines = light.on && (state.soloLight < 0 || state.soloLight == index);
    const ImVec2 kindSize = sizeIn(Face::Small, "directional");
    const std::string shown = elided(light.name, width - kindSize.x - points(16));
    const float middle = start.y + height / 2;
    drawText(*ImGui::GetWindowDrawList(), Face::Body, {start.x + points(6), middle - ImGui::GetFontSize() / 2},
             shines ? palette::text : palette::quiet, shown);
    const char* kind = light.kind == LightKind::Directional ? "directional" : "point";
    const float kindLeft = start.x + width - sizeIn(Face::Small, kind).x - points(6);
    drawText(*ImGui::GetWindowDrawList(), Face::Small, {kindLeft, middle - kindSize.y / 2},
             state.selectedLight == index ? palette::text : palette::quiet, kind);
}

/// Returns true where the light is to be removed.
bool drawRow(ExplorerState& state, int index)
{
    const float gap = points(4);
    const float soloWidth = points(42);
    const float removeWidth = ImGui::GetFrameHeight();
    drawSwitch(state.scene.lights[static_cast<std::size_t>(index)]);
    ImGui::SameLine(0, 0);
    drawName(state, index, ImGui::GetContentRegionAvail().x - soloWidth - removeWidth - 2 * gap);
    ImGui::SameLine(0, gap);
    const bool solo = state.soloLight == index;
    if (toggleButton("solo", solo, {soloWidth, 0}))
        state.soloLight = solo ? -1 : index;
    tooltip(solo ? "Let the other lights shine again." : "Only this light shines.");
    ImGui::SameLine(0, gap);
    const bool remove = ImGui::Button("\u00D7", {removeWidth, 0});
    tooltip("Remove this light.");
    return remove;
}

void drawAddButtons(ExplorerState& state)
{
    const float width = (ImGui::GetContentRegionAvail().x - points(6)) / 2;
    if (ImGui::Button("+ Directional", {width, 0}))
        addLight(state, LightKind::Directional);
    tooltip("Add a light like the sun: the same direction and intensity everywhere.");
    ImGui::SameLine(0, points(6));
    if (ImGui::Button("+ Point", {width, 0}))
        addLight(state, LightKind::Point);
    tooltip("Add a light that stands somewhere: I / r\u00B2 arrives at distance r.");
}

} // namespace

unsigned int swatchColor(const Light& light)
{
    const Vec3d tint = tintOf(light.intensity);
    const auto channel = [](double linear) {
        return static_cast<int>(quantised(encodeSrgb(std::clamp(linear, 0.0, 1.0))));
    };
    return IM_COL32(channel(tint.x), channel(tint.y), channel(tint.z), 255);
}

void addLight(ExplorerState& state, LightKind kind)
{
    std::vector<Light>& lights = state.scene.lights;
    Light light;
    light.kind = kind;
    light.name = freshName(lights, kind == LightKind::Directional ? "sun" : "lamp");
    // Each new one a golden angle further, so that handles do not hide each other.
    const double azimuth = std::remainder(40.0 + 137.5 * static_cast<double>(lights.size()), 360.0);
    light.direction = vectorOf({azimuth, 40.0, 1.0});
    light.position = vectorOf({azimuth, 40.0, 2.0});
    light.intensity = kind == LightKind::Directional ? Vec3d(0.5) : Vec3d(2.0);
    light.angularRadius = 3.0;
    lights.push_back(light);
    state.selectedLight = static_cast<int>(lights.size()) - 1;
}

void removeLight(ExplorerState& state, int index)
{
    state.scene.lights.erase(state.scene.lights.begin() + index);
    const int last = static_cast<int>(state.scene.lights.size()) - 1;
    if (state.selectedLight > index || state.selectedLight > last)
        --state.selectedLight;
    if (state.soloLight == index)
        state.soloLight = -1;
    else if (state.soloLight > index)
        --state.soloLight;
}

void drawLightList(ExplorerState& state)
{
    std::optional<std::size_t> removed;
    if (state.scene.lights.empty())
        remark("No lights: only an environment could light the object, and only a mirror looks at it.");
    else
        removed = rowList("lights", state.scene.lights.size(), "More lights are below.",
                          [&](std::size_t i) { return drawRow(state, static_cast<int>(i)); });
    if (removed)
        removeLight(state, static_cast<int>(*removed));
    drawAddButtons(state);
}

} // namespace reflectance::explorer
