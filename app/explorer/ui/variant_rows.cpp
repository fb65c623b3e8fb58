#include "app/explorer/ui/variant_rows.h"

#include "app/explorer/ui/row_list.h"
#include "app/explorer/ui/rung_row.h"
#include "app/explorer/ui/widgets.h"
#include "core/scene/variants.h"

#include <imgui.h>
#include <imgui_stdlib.h>

namespace reflectance::explorer {

namespace {

/// The name is typed into a copy: one that is taken or empty is not put in place.
void drawName(ExplorerState& state, std::size_t index, float width)
{
    std::string name = state.scene.variants[index].name;
    ImGui::SetNextItemWidth(width);
    const bool edited = ImGui::InputText("##name", &name);
    const auto renamed = edited ? renameVariant(state.scene, index, name) : Result<void>();
    const Surface& surface = state.scene.variants[index].surface;
    const std::string rungs = surface.rungs.empty() ? "" : ", " + rungsText(surface);
    tooltip("The variant's name: " + modelOf(surface).text.name + rungs +
            ". Type another one, which no other variant has." +
            (renamed ? std::string() : "\nNot yet: " + renamed.error().sentence() + "."));
}

/// True where the variant is to be removed.
bool drawRow(ExplorerState& state, std::size_t index)
{
    const float gap = points(4), side = ImGui::GetFrameHeight();
    const float renew = sizeIn(Face::Body, "renew").x + points(14);
    drawName(state, index, ImGui::GetContentRegionAvail().x - 3 * side - renew - 4 * gap);
    const Surface& surface = state.scene.variants[index].surface;
    ImGui::SameLine(0, gap);
    if (toggleButton("A", surface == state.scene.surface, {side, 0}))
        showAsA(state, index);
    tooltip("Show this variant as A. Pressed while A is as it was kept.");
    ImGui::SameLine(0, gap);
    const bool isB = state.compare.on && state.scene.other && surface == *state.scene.other;
    if (toggleButton("B", isB, {side, 0}))
        showAsB(state, index);
    tooltip("Compare this variant as B.");
    ImGui::SameLine(0, gap);
    if (ImGui::Button("renew", {renew, 0}))
        state.scene.variants[index].surface = surfaceInHand(state.compare, state.scene);
    tooltip("Keep what the panel shows now under this name.");
    ImGui::SameLine(0, gap);
    const bool remove = ImGui::Button("\u00D7", {side, 0});
    tooltip("Remove this variant. A and B stay as they are.");
    return remove;
}

void drawList(ExplorerState& state)
{
    std::vector<KeptSurface>& variants = state.scene.variants;
    if (const auto removed = rowList("variants", variants.size(), "More variants are below.",
                                     [&](std::size_t i) { return drawRow(state, i); }))
        variants.erase(variants.begin() + static_cast<std::ptrdiff_t>(*removed));
}

} // namespace

void showAsA(ExplorerState& state, std::size_t variant)
{
    state.scene.surface = state.scene.variants[variant].surface;
}

void showAsB(ExplorerState& state, std::size_t variant)
{
    state.scene.other = state.scene.variants[variant].surface;
    state.compare.on = true;
}

void variantRows(ExplorerState& state)
{
    const std::size_t count = state.scene.variants.size();
    const std::string label = count == 0 ? "Variants" : "Variants: " + std::to_string(count);
    if (!fold((label + "###variants").c_str(),
              "Surfaces of this scene under names of their own, to choose A and B from. Saved with the scene."))
        return;
    if (count > 0)
        drawList(state);
    if (ImGui::Button("+ Keep this surface", {ImGui::GetContentRegionAvail().x, 0}))
        keepVariant(state.scene, surfaceInHand(state.compare, state.scene));
    tooltip("Keep model, parameters and rungs as they are now, under a name.");
}

} // namespace reflectance::explorer
