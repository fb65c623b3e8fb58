#include "app/explorer/ui/workbench/probe_page.h"

#include "app/explorer/ui/numerals.h"
#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/probe_views.h"
#include "app/explorer/ui/workbench/terms_view.h"
#include "core/scene/names.h"

#include <algorithm>
#include <array>
#include <imgui_stdlib.h>

namespace reflectance::explorer {
namespace {

constexpr float widestControls = 196.0F, narrowestControls = 160.0F, narrowestColumn = 210.0F;

constexpr const char* scrollHint = "Drag, or turn the wheel, for what lies above and below.";

void detailRow(ProbeStudy& study)
{
    static constexpr Choice details[] = {
        {"Point", "One point of the picture, stage by stage, with the formula's numbers."},
        {"Terms", "Each term of the picture alone, and what it buys and costs."}};
    ImGui::PushID("detail");
    if (const int pressed = choiceRow(details, static_cast<int>(study.detail)); pressed >= 0)
        study.detail = static_cast<ProbeDetail>(pressed);
    ImGui::PopID();
}

/// A row of small buttons that breaks where the column ends.
void pinButtons(ExplorerState& state)
{
    ProbeStudy& study = state.probe;
    const float room = ImGui::GetContentRegionAvail().x, right = ImGui::GetCursorScreenPos().x + room;
    for (std::size_t i = 0; i < state.scene.pins.size(); ++i) {
        const std::string name = elided(state.scene.pins[i].name, room - points(12));
        const float width = std::max(points(28), sizeIn(Face::Body, name).x + points(12));
        if (i > 0 && ImGui::GetItemRectMax().x + points(2) + width <= right)
            ImGui::SameLine(0, points(2));
        if (toggleButton((name + "##pin" + std::to_string(i)).c_str(), study.picked == i, {width, 0}))
            study.pick(i);
        tooltip("Look at this pin.");
    }
}

/// The name of the pin that is looked at, typed into a copy: one that is taken or empty is not put in place.
void pinName(ExplorerState& state)
{
    const auto& picked = state.probe.picked;
    if (!picked || *picked >= state.scene.pins.size())
        return;
    std::string& current = state.scene.pins[*picked].name;
    std::string name = current;
    ImGui::SetNextItemWidth(-1);
    const bool edited = ImGui::InputText("##pin name", &name);
    const auto renamed = edited ? rename(state.scene.pins, current, name, "pin") : Result<void>();
    tooltip("The pin's name, on the object, in the CSV and in the scene file." +
            (renamed ? std::string() : "\nNot yet: " + renamed.error().sentence() + "."));
}

void pinRow(ExplorerState& state)
{
    ProbeStudy& study = state.probe;
    const float width = (ImGui::GetContentRegionAvail().x - points(4)) / 2;
    const bool canPin = study.loose && !study.picked && state.scene.pins.size() < mostPins;
    ImGui::BeginDisabled(!canPin);
    if (ImGui::Button("Pin", {width, 0}))
        study.pin(state.scene);
    ImGui::EndDisabled();
    tooltip("Keep this probe on the object, under a name, while others are made. It stays on its point when the "
            "camera moves, and is saved with the scene; at most 20.");
    ImGui::SameLine(0, points(4));
    ImGui::BeginDisabled(!study.looks(state.scene));
    if (ImGui::Button("Remove", {width, 0}))
        study.remove(state.scene);
    ImGui::EndDisabled();
    tooltip("Take this probe off the object.");
}

void copyRows(ExplorerState& state)
{
    const ProbeStudy& study = state.probe;
    const FoundProbe* found = study.found();
    const float width = (ImGui::GetContentRegionAvail().x - points(4)) / 2;
    ImGui::BeginDisabled(!found);
    if (ImGui::Button("Copy text", {width, 0}))
        ImGui::SetClipboardText(textOf(*found).c_str());
    ImGui::EndDisabled();
    tooltip("This probe as text, to the clipboard: every statement with its numbers.");
    const std::vector<Probe> all = listed(study, state.scene);
    ImGui::BeginDisabled(all.empty());
    ImGui::SameLine(0, points(4));
    if (ImGui::Button("Copy CSV", {width, 0}))
        ImGui::SetClipboardText(probeCsv(all).c_str());
    tooltip("All pins and this probe as CSV, to the clipboard: a row for each light.");
    if (ImGui::Button("Save CSV", {-1, 0}))
        state.requests.push_back({Request::Kind::SaveText, "probes.csv", probeCsv(all)});
    tooltip("The same into the pictures folder.");
    ImGui::EndDisabled();
}

void overlayRow(ProbeStudy& study)
{
    const float width = (ImGui::GetContentRegionAvail().x - points(4)) / 2;
    if (toggleButton("Arrows", study.arrows, {width, 0}))
        study.arrows = !study.arrows;
    tooltip("Draw N, L, V and R at the point: normal, to the light, to the eye, L mirrored about N. V points at the "
            "eye, so it "
            "is a dot in a circle.");
    ImGui::SameLine(0, points(4));
    if (toggleButton("Lobe", study.lobe, {width, 0})) {
        study.lobe = !study.lobe;
    }
    tooltip(
        "Draw on the object how the surface spreads this light over all directions to an eye: the factor, mean of the "
        "channels. The thick line lies in the plane of N and L.");
}

void pointControls(ExplorerState& state)
{
    ProbeStudy& study = state.probe;
    pinButtons(state);
    pinName(state);
    pinRow(state);
    overlayRow(study);
    const FoundProbe* found = study.found();
    if (found && found->b) {
        static constexpr Choice variants[] = {{"A", "The formula of A's surface."},
                                              {"B", "The formula of B's surface."}};
        ImGui::PushID("variant");
        if (const int pressed = choiceRow(variants, study.onB ? 1 : 0); pressed >= 0)
            study.onB = pressed == 1;
        ImGui::PopID();
    }
    copyRows(state);
    const std::optional<LobeShape>& lobe = study.onB && study.lobeB ? study.lobeB : study.lobeA;
    if (study.lobe && lobe && lobe->largest > 0.0)
        remark("The lobe's longest is " + written(lobe->largest, 3) + ".");
}

void sensors(const FoundProbe& found)
{
    drawProbedSensor(found.a, found.pixelA, found.b ? "A" : "");
    if (found.b)
        drawProbedSensor(*found.b, found.pixelB, "B");
}

/// Three columns where there is room for them, else one below the other.
void drawStages(ProbeStudy& study, const FoundProbe& found)
{
    const Probe& probe = study.onB && found.b ? *found.b : found.a;
    const float room = ImGui::GetContentRegionAvail().x;
    const float gap = points(12);
    if (room < 3 * points(narrowestColumn) + 2 * gap) {
        ImGui::BeginChild("stages", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
        drawProbedLights(study, probe);
        ImGui::Separator();
        drawProbedSurface(study, probe);
        ImGui::Separator();
        sensors(found);
        scrollBarTooltip(scrollHint);
        ImGui::EndChild();
        return;
    }
    // The surface has the longest lines.
    const float side = std::clamp(0.3F * room, points(narrowestColumn), points(330));
    const std::array<float, 3> widths{side, room - 2 * side - 2 * gap, side};
    for (int i = 0; i < 3; ++i) {
        if (i > 0)
            ImGui::SameLine(0, gap);
        ImGui::PushID(i);
        ImGui::BeginChild("stage", {widths[static_cast<std::size_t>(i)], 0}, false, ImGuiWindowFlags_NavFlattened);
        if (i == 0)
            drawProbedLights(study, probe);
        else if (i == 1)
            drawProbedSurface(study, probe);
        else
            sensors(found);
        scrollBarTooltip(scrollHint);
        ImGui::EndChild();
        ImGui::PopID();
    }
}

void drawPoint(ExplorerState& state)
{
    ProbeStudy& study = state.probe;
    if (const FoundProbe* found = study.found())
        return drawStages(study, *found);
    remark(study.looks(state.scene)
               ? "This pin lies on another object; it comes back with it."
               : "Click a point of the object, or press P over it: light, surface and sensor at that point, with the "
                 "formula's numbers filled in, in double, and what GL drew beside it.");
}

} // namespace

void drawProbePage(ExplorerState& state)
{
    ProbeStudy& study = state.probe;
    const float controls =
        std::clamp(0.36F * ImGui::GetContentRegionAvail().x, points(narrowestControls), points(widestControls));
    ImGui::BeginChild("controls", {controls, 0}, false, ImGuiWindowFlags_NavFlattened);
    detailRow(study);
    if (study.detail == ProbeDetail::Point)
        pointControls(state);
    else
        drawTermChoices(state);
    scrollBarTooltip(scrollHint);
    ImGui::EndChild();
    ImGui::SameLine(0, points(12));
    if (study.detail == ProbeDetail::Point)
        return drawPoint(state);
    ImGui::BeginChild("bars", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
    drawTermBars(state);
    scrollBarTooltip(scrollHint);
    ImGui::EndChild();
}

} // namespace reflectance::explorer
