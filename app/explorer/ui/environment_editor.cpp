#include "app/explorer/ui/environment_editor.h"

#include "app/explorer/ui/light_angles.h"
#include "app/explorer/ui/light_editor.h"
#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/widgets.h"

#include <array>
#include <filesystem>

namespace reflectance::explorer {

namespace {

struct KindEntry {
    EnvironmentKind kind;
    const char* name;
    const char* about;
};

constexpr std::array<KindEntry, 4> kinds = {{
    {EnvironmentKind::None, "none", "Black around the object."},
    {EnvironmentKind::Constant, "constant", "The same radiance from everywhere."},
    {EnvironmentKind::Studio, "studio", "A gradient, a floor grid and soft boxes, computed."},
    {EnvironmentKind::Map, "picture", "A latitude-longitude picture, .exr or .hdr."},
}};

void openPicture(ExplorerState& state)
{
    state.showFileBrowser = true;
}

void drawKindMenu(ExplorerState& state)
{
    Environment& environment = state.scene.environment;
    rowLabel("", "Environment");
    const bool open = beginMenu("##environment", nameOf(environment.kind));
    tooltip("The light that surrounds the object.");
    if (!open)
        return;
    for (const KindEntry& entry : kinds) {
        const bool needsFile = entry.kind == EnvironmentKind::Map && !environment.map;
        const std::string label = std::string(entry.name) + (needsFile ? "\u2026" : "");
        if (ImGui::Selectable(label.c_str(), environment.kind == entry.kind)) {
            if (needsFile)
                openPicture(state); // becomes the environment once it has been read
            else
                environment.kind = entry.kind;
        }
        tooltip(entry.about);
    }
    ImGui::EndCombo();
}

void drawFile(ExplorerState& state)
{
    rowLabel("", "Picture");
    const std::string file = std::filesystem::path(state.scene.environment.file).filename().string();
    const std::string label =
        elided(file.empty() ? "choose\u2026" : file, ImGui::GetContentRegionAvail().x - points(18)) +
        "##choose picture";
    if (ImGui::Button(label.c_str(), {-1, 0}))
        openPicture(state);
    tooltip(state.scene.environment.file +
            "\nChoose another latitude-longitude picture (.exr, .hdr); or drop one on the window.");
}

void drawRadiance(Environment& environment, std::optional<Message>& message)
{
    NumberRow row;
    row.name = "environment radiance";
    row.label = environment.kind == EnvironmentKind::Constant ? "Radiance" : "Factor";
    row.about = environment.kind == EnvironmentKind::Constant
                    ? "Radiance from every direction; largest channel."
                    : "The environment's radiance is multiplied by this; largest channel.";
    row.sliderMin = 0.01;
    row.sliderMax = 100.0;
    row.logarithmic = true;
    row.legalMin = 0.0;
    row.initial = 1.0;
    double strength = strengthOf(environment.radiance);
    if (numberRow(row, strength, message))
        environment.radiance = tintOf(environment.radiance) * strength;
}

void drawRotation(Environment& environment, std::optional<Message>& message)
{
    NumberRow row;
    row.name = "rotation";
    row.label = "Rotation";
    row.unit = "\u00B0";
    row.about = "About the vertical (y).";
    row.sliderMin = -180.0;
    row.sliderMax = 180.0;
    row.legalMin = -360.0;
    row.legalMax = 360.0;
    numberRow(row, environment.rotation, message);
}

void drawBackground(reflectance::Background& background)
{
    constexpr std::array<Choice, 2> choices = {{
        // in the order of BackgroundKind
        {"plain", "A dark neutral grey behind the object."},
        {"environment", "Show the environment behind the object."},
    }};
    rowLabel("", "Background");
    if (const int pressed = choiceRow(choices, static_cast<int>(background.kind)); pressed >= 0)
        background.kind = static_cast<BackgroundKind>(pressed);
}

} // namespace

const char* nameOf(EnvironmentKind kind)
{
    return kinds[static_cast<std::size_t>(kind)].name;
}

void drawEnvironmentEditor(ExplorerState& state)
{
    Scene& scene = state.scene;
    ImGui::PushID("environment");
    drawKindMenu(state);
    const bool looksAtIt = modelOf(scene).text.usesEnvironment;
    const bool seen = looksAtIt || scene.background.kind == BackgroundKind::Environment;
    if (seen && scene.environment.kind != EnvironmentKind::None) {
        if (scene.environment.kind == EnvironmentKind::Map)
            drawFile(state);
        drawRadiance(scene.environment, state.message);
        if (scene.environment.kind != EnvironmentKind::Constant)
            drawRotation(scene.environment, state.message);
    }
    drawBackground(scene.background);
    if (!looksAtIt)
        remark(modelOf(scene).text.name + " is lit by the lights alone; only " +
               modelsThat(&ModelText::usesEnvironment) + " looks at the environment.");
    ImGui::PopID();
}

} // namespace reflectance::explorer
