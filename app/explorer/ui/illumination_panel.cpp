#include "app/explorer/ui/illumination_panel.h"

#include "app/explorer/ui/card.h"
#include "app/explorer/ui/environment_editor.h"
#include "app/explorer/ui/light_editor.h"
#include "app/explorer/ui/light_list.h"
#include "app/explorer/ui/widgets.h"

namespace reflectance::explorer {

namespace {

std::string summaryOf(const Scene& scene)
{
    const auto shining = shiningLights(scene).size();
    return std::to_string(shining) + (shining == 1 ? " light" : " lights") + ", " + nameOf(scene.environment.kind);
}

void divider()
{
    ImGui::Dummy({0, points(1)});
    ImGui::Separator();
    ImGui::Dummy({0, points(1)});
}

} // namespace

void drawIlluminationPanel(ExplorerState& state)
{
    const Card card(
        {1, "Illumination", summaryOf(state.scene),
         "The light that arrives: direction L and intensity I of every light, and what surrounds the object."});
    if (!card.isOpen())
        return;
    drawLightList(state);
    if (state.selectedLight >= 0 && !state.scene.lights.empty()) {
        divider();
        drawLightEditor(state);
    }
    divider();
    drawEnvironmentEditor(state);
}

} // namespace reflectance::explorer
