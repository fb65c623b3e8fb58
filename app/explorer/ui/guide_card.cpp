#include "app/explorer/ui/guide_card.h"

#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

namespace reflectance::explorer {

namespace {

using Kind = Request::Kind;

void showStep(ExplorerState& state, int number)
{
    state.requests.push_back({Kind::ShowTour, std::to_string(number)});
}

/// Which step this is, as a row of dots to click.
void drawDots(ExplorerState& state)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float each = width / static_cast<float>(tourLength());
    for (int number = 1; number <= tourLength(); ++number) {
        ImGui::PushID(number);
        ImGui::SetCursorScreenPos({start.x + each * static_cast<float>(number - 1), start.y});
        if (ImGui::InvisibleButton("dot", {each, points(14)}))
            showStep(state, number);
        const bool hovered = ImGui::IsItemHovered();
        const std::string about = "Step " + std::to_string(number) + " of " + std::to_string(tourLength());
        tooltip(about);
        const bool reached = number <= state.guide.number;
        ImGui::GetWindowDrawList()->AddRectFilled(
            {start.x + each * static_cast<float>(number - 1), start.y + points(5)},
            {start.x + each * static_cast<float>(number) - points(3), start.y + points(9)},
            hovered   ? palette::text
            : reached ? palette::accent
                      : palette::raised,
            points(2));
        ImGui::PopID();
    }
}

void drawHead(ExplorerState& state)
{
    const std::string place =
        "Guided tour, " + std::to_string(state.guide.number) + " of " + std::to_string(tourLength());
    ImGui::AlignTextToFramePadding();
    remark(place);
    const float width = sizeIn(Face::Body, "Close").x + points(16);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
    if (ImGui::Button("Close", {width, 0}))
        state.requests.push_back({Kind::LeaveCase, {}});
    tooltip("Leave the tour: your scene comes back as you left it.  Esc. The tour remembers where you were.");
    drawDots(state);
    remark(state.guide.step.title, palette::text, Face::Strong);
}

void heading(const char* text)
{
    ImGui::Dummy({0, points(2)});
    remark(text, palette::accent, Face::Strong);
}

void drawChoices(Guide& guide)
{
    for (int number = 1; number <= static_cast<int>(guide.step.choices.size()); ++number) {
        const std::string& choice = guide.step.choices[static_cast<std::size_t>(number - 1)];
        ImGui::PushID(number);
        ImU32 color = palette::text;
        if (guide.revealed)
            color = number == guide.step.right ? palette::good : palette::quiet;
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::PushStyleColor(ImGuiCol_FrameBg, palette::raised); // the card's ground is that of the controls
        const bool pressed = ImGui::RadioButton("##choice", guide.picked == number);
        ImGui::PopStyleColor();
        if (pressed && !guide.revealed)
            guide.picked = number;
        tooltip(guide.revealed ? "The answer is below."
                               : "What do you expect? You can change your mind until you look.");
        ImGui::SameLine();
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(choice.c_str());
        ImGui::PopTextWrapPos();
        if (ImGui::IsItemClicked() && !guide.revealed)
            guide.picked = number;
        ImGui::PopStyleColor();
        ImGui::PopID();
    }
}

void drawMeasured(const Guide& guide)
{
    ImGui::Dummy({0, points(2)});
    remark("Measured just now:");
    for (std::size_t i = 0; i < guide.values.size(); ++i)
        remark(guide.step.claims[i].says + ": " + claimText(guide.step.claims[i], guide.values[i]),
               holds(guide.step.claims[i], guide.values[i]) ? palette::quiet : palette::error);
}

void drawAnswer(Guide& guide)
{
    if (!guide.revealed) {
        ImGui::BeginDisabled(guide.picked == 0);
        if (ImGui::Button("Show the answer"))
            revealAnswer(guide);
        ImGui::EndDisabled();
        tooltip(guide.picked == 0 ? "Choose one first: a guess that turns out wrong is remembered best."
                                  : "Look, and have it measured.");
        return;
    }
    const bool right = guide.picked == guide.step.right;
    remark(right ? "Right." : "Not quite.", right ? palette::good : palette::warning, Face::Strong);
    remark(guide.step.answer, palette::text, Face::Body);
    drawMeasured(guide);
}

void drawFoot(ExplorerState& state)
{
    const float space = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * space) / 3;
    const int number = state.guide.number;
    ImGui::BeginDisabled(number <= 1);
    if (ImGui::Button("Back", {width, 0}))
        showStep(state, number - 1);
    ImGui::EndDisabled();
    tooltip("The step before.  Page up");
    ImGui::SameLine();
    if (ImGui::Button("Again", {width, 0}))
        showStep(state, number);
    tooltip("This step from its beginning, as it was before you changed it.");
    ImGui::SameLine();
    if (number < tourLength()) {
        if (ImGui::Button("Next", {width, 0}))
            showStep(state, number + 1);
        tooltip("The next step.  Page down");
    } else {
        if (ImGui::Button("Finish", {width, 0}))
            state.requests.push_back({Kind::LeaveCase, {}});
        tooltip("Back to your scene. The rest is yours to try.");
    }
}

} // namespace

std::string claimText(const Claim& claim, double value)
{
    return claim.measure.asCode ? general(value, 4) : general(value, 3);
}

void drawGuideCard(ExplorerState& state)
{
    Guide& guide = state.guide;
    if (guide.number == 0)
        return;
    drawHead(state);
    const float foot = ImGui::GetFrameHeightWithSpacing() + points(4);
    ImGui::PushID(guide.number); // each step begins at its top
    ImGui::BeginChild("##step", {0, -foot}, false);
    for (const std::string& paragraph : guide.step.text) {
        remark(paragraph, palette::text, Face::Body);
        ImGui::Dummy({0, points(1)});
    }
    heading("Try");
    remark(guide.step.task, palette::text, Face::Body);
    heading("Predict");
    remark(guide.step.question, palette::text, Face::Body);
    drawChoices(guide);
    drawAnswer(guide);
    scrollBarTooltip("The step goes on below.");
    ImGui::EndChild();
    ImGui::PopID();
    drawFoot(state);
}

} // namespace reflectance::explorer
