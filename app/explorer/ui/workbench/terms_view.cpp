#include "app/explorer/ui/workbench/terms_view.h"

#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/trade_views.h"
#include "app/explorer/viewed_scene.h"
#include "core/scene/only_term.h"

namespace reflectance::explorer {
namespace {

/// A button as wide as the column.
bool choice(const std::string& label, const std::string& id, bool on)
{
    ImGui::PushFont(face(Face::Body));
    const std::string shown = elided(label, ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().FramePadding.x);
    ImGui::PopFont();
    return toggleButton((shown + "##" + id).c_str(), on, {-1, 0});
}

std::string capital(std::string text)
{
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

const char* aboutTerm(const std::string& term)
{
    if (term == "offdiagonal")
        return "What K's entries beside its diagonal add: light of one colour that another sensor sees. Entries below "
               "0 "
               "show black.";
    return "The picture of this term of the formula alone. The scene stays as it is; Esc shows the whole.";
}

} // namespace

void drawTermChoices(ExplorerState& state)
{
    std::string& term = state.probe.term;
    if (choice("Whole picture", "all", !seesTermAlone(state)))
        term.clear();
    tooltip("Every term of the formula.");
    bool any = false;
    for (const std::string& name : termsAlone(state.scene)) {
        if (name.starts_with("light:"))
            continue; // below: solo does the same, in the picture and in the list of lights
        any = true;
        const bool on = term == name;
        if (choice(capital(wordsFor(name)), name, on))
            term = on ? std::string() : name;
        tooltip(aboutTerm(name));
    }
    if (!any)
        remark("This formula is one term.");
    remark("One light alone");
    for (std::size_t i = 0; i < state.scene.lights.size(); ++i) {
        const bool on = state.soloLight == static_cast<int>(i);
        if (choice(std::to_string(i + 1) + "  " + state.scene.lights[i].name, "light" + std::to_string(i), on))
            state.soloLight = on ? -1 : static_cast<int>(i);
        tooltip("The picture under this light alone; again for all of them.");
    }
}

void drawTermBars(ExplorerState& state)
{
    TradeStudy& study = state.trade;
    if (study.measuringTerms || study.running) {
        remark("The picture is drawn without each of its terms in turn\u2026");
    } else {
        if (ImGui::Button(study.terms ? "Measure again" : "Measure the terms"))
            study.termsAsked = true;
        tooltip("Takes one term after the other out of this view: what the picture loses (dE2000, RMSE) and what "
                "shading it "
                "again saves (ms). A few seconds; what else the machine does shows in the times.");
    }
    if (study.terms)
        drawTradeTerms(study);
    else if (!study.measuringTerms)
        remark("A bar for each term: diffuse, specular, off-diagonal K, roughness, every light. What a term buys is "
               "how far the "
               "picture is off without it.");
}

} // namespace reflectance::explorer
