#include "app/explorer/ui/light_editor.h"

#include "app/explorer/ui/light_angles.h"
#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/sensor/sensor.h"

#include <array>
#include <imgui_stdlib.h>

namespace reflectance::explorer {

namespace {

constexpr const char* degrees = "\u00B0";

/// What double-clicks go back to.
const Light& freshLight()
{
    static const Light light;
    return light;
}

void drawNameAndKind(Light& light)
{
    rowLabel("", "Name");
    ImGui::InputText("##name", &light.name);
    tooltip("The light's name, for messages and scene files.");
    rowLabel("", "Kind");
    constexpr std::array<Choice, 2> kinds = {{
        // in the order of LightKind
        {"directional", "Like the sun: the same direction L and intensity I everywhere."},
        {"point", "Stands somewhere: I / r\u00B2 arrives at distance r. The object's bounding sphere has radius 1."},
    }};
    if (const int pressed = choiceRow(kinds, static_cast<int>(light.kind)); pressed >= 0)
        light.kind = static_cast<LightKind>(pressed);
}

NumberRow angleRow(const char* name, const char* symbol, const char* label, double limit, const char* about)
{
    NumberRow row;
    row.name = name;
    row.symbol = symbol;
    row.label = label;
    row.unit = degrees;
    row.about = about;
    row.sliderMin = row.legalMin = -limit;
    row.sliderMax = row.legalMax = limit;
    return row;
}

NumberRow distanceRow(const LightAngles& initial)
{
    NumberRow row;
    row.name = "distance";
    row.symbol = "r";
    row.label = "Distance";
    row.about = "From the object's centre, in radii of its bounding sphere. I / r\u00B2 arrives.";
    row.sliderMin = 0.2;
    row.sliderMax = 20.0;
    row.logarithmic = true;
    row.legalMin = smallestLightDistance;
    row.initial = initial.distance;
    return row;
}

bool drawAngles(LightAngles& angles, const LightAngles& initial, bool withDistance, std::optional<Message>& message)
{
    NumberRow azimuth = angleRow("azimuth", "\u03C6", "Azimuth", 180.0,
                                 "About the vertical: 0\u00B0 is +z, towards the first view; 90\u00B0 is +x.");
    NumberRow elevation =
        angleRow("elevation", "\u03B8", "Elevation", 90.0, "Above the horizon: 90\u00B0 is straight above, +y.");
    azimuth.initial = initial.azimuth;
    elevation.initial = initial.elevation;
    bool changed = numberRow(azimuth, angles.azimuth, message);
    changed |= numberRow(elevation, angles.elevation, message);
    if (withDistance)
        changed |= numberRow(distanceRow(initial), angles.distance, message);
    return changed;
}

constexpr std::array<double Vec3d::*, 3> components = {&Vec3d::x, &Vec3d::y, &Vec3d::z};

/// One slider for each of x, y and z, made after the pattern. Returns which one changed, or -1.
int drawComponents(const NumberRow& pattern, Vec3d& v, const Vec3d& initial, std::optional<Message>& message)
{
    constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
    rowLabel(pattern.symbol, pattern.label);
    const float gap = points(4);
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    int changed = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        NumberRow row = pattern;
        row.name = axes[i];
        row.label += std::string(" ") + axes[i];
        row.initial = initial.*components[i];
        if (numberField(row, v.*components[i], width, message))
            changed = static_cast<int>(i);
        if (i < 2)
            ImGui::SameLine(0, gap);
    }
    return changed;
}

void drawPlace(Light& light, std::optional<Message>& message)
{
    const bool isPoint = light.kind == LightKind::Point;
    Vec3d& place = isPoint ? light.position : light.direction;
    LightAngles angles = anglesOf(place);
    if (!isPoint)
        angles.distance = 1.0;
    if (drawAngles(angles, anglesOf(isPoint ? freshLight().position : freshLight().direction), isPoint, message))
        place = vectorOf(angles);
}

void drawDirection(Light& light, std::optional<Message>& message)
{
    NumberRow pattern;
    pattern.symbol = "L";
    pattern.label = "Direction";
    pattern.about = "To the light, of length 1: the other two components follow in their ratio.";
    pattern.sliderMin = pattern.legalMin = -1.0;
    pattern.sliderMax = pattern.legalMax = 1.0;
    const Vec3d unit = normalized(light.direction);
    Vec3d edited = unit;
    const int axis = drawComponents(pattern, edited, normalized(freshLight().direction), message);
    if (axis >= 0)
        light.direction =
            withComponent(unit, static_cast<std::size_t>(axis), edited.*components[static_cast<std::size_t>(axis)]);
}

void drawPosition(Light& light, std::optional<Message>& message)
{
    NumberRow pattern;
    pattern.label = "Position";
    pattern.about = "Where the light stands; the object's bounding sphere has radius 1.";
    pattern.sliderMin = -4.0;
    pattern.sliderMax = 4.0;
    drawComponents(pattern, light.position, freshLight().position, message);
}

/// The tint survives strength 0, although intensity = strength * tint does not.
Vec3d& tintToEdit(const Light& light, int index, PanelMemory& memory)
{
    if (strengthOf(light.intensity) > 0.0 || memory.tintOf != index)
        memory.tint = tintOf(light.intensity);
    memory.tintOf = index;
    return memory.tint;
}

void drawStrength(Light& light, const Vec3d& tint, std::optional<Message>& message)
{
    NumberRow row;
    row.name = "intensity";
    row.symbol = "I";
    row.label = "Intensity";
    row.about = "Largest channel of I: the radiance of a perfect white diffuser that faces the light. 1 fills the "
                "sensor at exposure 0.";
    row.sliderMin = 0.01;
    row.sliderMax = 100.0;
    row.logarithmic = true;
    row.legalMin = 0.0;
    row.initial = 1.0;
    double strength = strengthOf(light.intensity);
    if (numberRow(row, strength, message))
        light.intensity = tint * strength;
}

/// The picker works on encoded values, as the eye compares; the light keeps linear ones.
void drawTint(Light& light, Vec3d& tint)
{
    rowLabel("", "Colour");
    float encoded[3] = {static_cast<float>(encodeSrgb(tint.x)), static_cast<float>(encodeSrgb(tint.y)),
                        static_cast<float>(encodeSrgb(tint.z))};
    if (ImGui::ColorEdit3("##tint", encoded,
                          ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_PickerHueWheel |
                              ImGuiColorEditFlags_NoTooltip)) {
        const Vec3d picked(decodeSrgb(static_cast<double>(encoded[0])), decodeSrgb(static_cast<double>(encoded[1])),
                           decodeSrgb(static_cast<double>(encoded[2])));
        if (strengthOf(picked) > 0.0) // black is no tint; the intensity makes a light dark
            tint = tintOf(picked);
        light.intensity = tint * strengthOf(light.intensity);
    }
    tooltip("Colour of the light at its intensity: red, green, blue as sRGB codes. I = (" +
            general(light.intensity.x, 4) + ", " + general(light.intensity.y, 4) + ", " +
            general(light.intensity.z, 4) + "), linear.");
}

void drawRadius(Light& light, bool counts, std::optional<Message>& message)
{
    NumberRow row;
    row.name = "angular radius";
    row.label = "Angular radius";
    row.unit = degrees;
    row.about =
        "How large a mirror shows the light; the sun has 0.27\u00B0. A light of radius 0 is met by no view direction.";
    row.sliderMax = 20.0;
    row.legalMin = 0.0;
    row.legalMax = 90.0;
    ImGui::BeginDisabled(!counts);
    numberRow(row, light.angularRadius, message);
    ImGui::EndDisabled();
    if (!counts)
        remark("Only " + modelsThat(&ModelText::usesLightSize) + " looks at the radius.");
    else if (light.angularRadius == 0.0)
        remark("Radius 0: no view direction meets this light, so it adds nothing.", palette::warning);
}

} // namespace

std::string modelsThat(bool ModelText::*uses)
{
    std::vector<std::string> names;
    for (const Model& model : catalogue())
        if (model.text.*uses)
            names.push_back(model.text.name);
    return joined(names);
}

void drawLightEditor(ExplorerState& state)
{
    const int index = state.selectedLight;
    if (index < 0 || index >= static_cast<int>(state.scene.lights.size()))
        return;
    Light& light = state.scene.lights[static_cast<std::size_t>(index)];
    ImGui::PushID("light editor");
    ImGui::PushID(index);
    Vec3d& tint = tintToEdit(light, index, state.panels);
    drawStrength(light, tint, state.message);
    drawTint(light, tint);
    drawPlace(light, state.message);
    const bool radiusCounts = modelOf(state.scene).text.usesLightSize;
    if (radiusCounts)
        drawRadius(light, true, state.message);
    if (fold("Name, kind, vector", "What is needed less often: name, kind, the vector itself, the radius.")) {
        drawNameAndKind(light);
        if (light.kind == LightKind::Directional)
            drawDirection(light, state.message);
        else
            drawPosition(light, state.message);
        if (!radiusCounts)
            drawRadius(light, false, state.message);
    }
    ImGui::PopID();
    ImGui::PopID();
}

} // namespace reflectance::explorer
