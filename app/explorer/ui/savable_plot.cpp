#include "app/explorer/ui/savable_plot.h"

#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

constexpr const char* word = "Save";

/// What a PNG holds, as the request says it.
std::string regionText(ImVec2 topLeft, ImVec2 size)
{
    std::string text;
    for (const float number : {topLeft.x, topLeft.y, size.x, size.y})
        text += (text.empty() ? "" : " ") + general(static_cast<double>(number), 7);
    return text;
}

/// The word and an arrow, quiet until the mouse is on it.
bool saveButton(ImVec2 size, bool visible)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton("save", size);
    const bool touched = ImGui::IsItemHovered() || ImGui::IsItemFocused() || ImGui::IsPopupOpen("formats");
    tooltip(
        "Saves this plot into the pictures folder: as a drawing (SVG), as it is seen (PNG), or as its numbers (CSV).");
    if (!visible)
        return pressed;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = touched ? palette::text : palette::quiet;
    if (touched)
        list.AddRectFilled(start, {start.x + size.x, start.y + size.y}, palette::raised, points(3));
    drawText(list, Face::Small, {start.x + points(6), start.y + (size.y - sizeIn(Face::Small, word).y) / 2}, color,
             word);
    const ImVec2 middle{start.x + size.x - points(10), start.y + size.y / 2};
    const float r = points(3.5F);
    list.AddTriangleFilled({middle.x - r, middle.y - r / 2}, {middle.x + r, middle.y - r / 2},
                           {middle.x, middle.y + r / 2}, palette::accent);
    return pressed;
}

void formats(const PlotFiles& files, ImVec2 topLeft, ImVec2 size, ExplorerState& state)
{
    using Kind = Request::Kind;
    const auto entry = [&](const char* label, const char* about, Kind kind, const char* ending, const auto& text) {
        if (ImGui::Selectable(label, false, 0, {points(64), 0}))
            state.requests.push_back({kind, files.name + ending, text()});
        tooltip(about);
    };
    entry("SVG", "A drawing on white, for papers: it stays sharp at every size.", Kind::SaveText, ".svg", files.svg);
    entry("PNG", "The plot as it is on the screen.", Kind::SaveRegion, ".png",
          [&] { return regionText(topLeft, size); });
    entry("CSV", "The plot's numbers; they read back to the same doubles.", Kind::SaveText, ".csv", files.csv);
}

} // namespace

float plotHeadingHeight()
{
    return points(20);
}

void plotHeading(const PlotFiles& files, ImVec2 size, ExplorerState& state)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 button{sizeIn(Face::Small, word).x + points(24), points(18)};
    ImGui::PushID(files.name.c_str());
    ImGui::PushFont(face(Face::Small));
    const std::string title = elided(files.title, std::max(1.0F, size.x - button.x - points(8)));
    ImGui::PopFont();
    drawText(*ImGui::GetWindowDrawList(), Face::Small,
             {start.x + points(2), start.y + (button.y - sizeIn(Face::Small, title).y) / 2}, palette::quiet, title);
    ImGui::SetCursorScreenPos({start.x + std::max(0.0F, size.x - button.x), start.y});
    if (saveButton(button, !state.takingPicture))
        ImGui::OpenPopup("formats");
    ImGui::SetNextWindowPos({start.x + size.x - points(84), start.y + button.y + points(2)});
    if (ImGui::BeginPopup("formats")) {
        formats(files, start, size, state);
        ImGui::EndPopup();
    }
    ImGui::PopID();
    ImGui::SetCursorScreenPos({start.x, start.y + plotHeadingHeight()});
}

} // namespace reflectance::explorer
