#include "app/explorer/ui/history_buttons.h"
#include "app/explorer/ui/tool_button.h"
#include "app/explorer/ui/ui.h"
#include "app/explorer/ui/widgets.h"
#include "core/geometry/load.h"

#include <array>
#include <cmath>
#include <filesystem>

namespace reflectance::explorer {

namespace {

using Kind = Request::Kind;

void listEarlierSessions(ExplorerState& state)
{
    if (state.earlierSessions.empty())
        return;
    ImGui::Separator();
    remark("Before a crash");
    for (const EarlierSession& session : state.earlierSessions) {
        const std::string name = session.content.empty() ? "unreadable" : session.content;
        if (ImGui::Selectable((name + ", " + session.when + "##" + session.file).c_str()))
            state.requests.push_back({Kind::OpenFile, session.file});
        tooltip("Restore this session.  " + session.file);
    }
}

void openMenu(ExplorerState& state)
{
    if (ImGui::Selectable("Open a file\u2026"))
        state.showFileBrowser = true;
    tooltip("Mesh (.obj .ply .off .stl), scene (.json), saved picture (.png) or environment (.exr .hdr).  Ctrl+O");
    bool& smooth = state.scene.recomputeNormals;
    if (ImGui::Selectable("Smooth normals", smooth)) {
        smooth = !smooth;
        state.requests.push_back({Kind::OpenFile, state.scene.meshFile});
    }
    tooltip("Compute the normals anew even where the file gives some: faceted files look round. Reads the mesh again.");
    ImGui::Separator();
    remark("Built in");
    for (const std::string& name : stockMeshNames())
        if (ImGui::Selectable(name.c_str(), state.scene.meshFile == name))
            state.requests.push_back({Kind::OpenFile, name});
    listEarlierSessions(state);
    if (state.preferences.recentFiles.empty())
        return;
    ImGui::Separator();
    remark("Recent");
    for (const std::string& path : state.preferences.recentFiles) {
        const std::string label = std::filesystem::path(path).filename().string() + "##" + path;
        if (ImGui::Selectable(label.c_str()))
            state.requests.push_back({Kind::OpenFile, path});
        tooltip(path);
    }
}

void drawOpenButton(ExplorerState& state, bool withLabels)
{
    const ImVec2 below{ImGui::GetCursorScreenPos().x, ImGui::GetCursorScreenPos().y + toolButtonHeight() + points(4)};
    if (drawToolButton({Icon::Open, "Open", ImGui::IsPopupOpen("open menu"), withLabels},
                       "Open a file, a built-in mesh or a recent file.  Ctrl+O"))
        ImGui::OpenPopup("open menu");
    ImGui::SetNextWindowPos(below);
    ImGui::SetNextWindowSizeConstraints({points(190), 0}, {points(420), points(560)});
    if (ImGui::BeginPopup("open menu")) {
        openMenu(state);
        ImGui::EndPopup();
    }
}

constexpr std::array<const char*, 9> leftLabels = {"Open",    "Frame", "Turntable", "Handles", "Grab",
                                                   "Compare", "Lens",  "Picture",   "Reset"};

bool labelsFit(float width)
{
    float wanted =
        toolButtonWidth("Help", true) + toolButtonWidth("Tour", true) + points(2) + historyButtonsWidth() + points(40);
    for (const char* label : leftLabels)
        wanted += toolButtonWidth(label, true) + points(2);
    return wanted <= width;
}

/// Name of the object, in the middle of what is left between the buttons.
void drawTitle(const ExplorerState& state, float left, float right, float middle)
{
    const std::string name = state.scene.mesh ? state.scene.mesh->name : std::string();
    ImGui::PushFont(face(Face::Strong));
    const std::string shown = elided(name, right - left - points(24));
    ImGui::PopFont();
    const ImVec2 size = sizeIn(Face::Strong, shown);
    if (right - left < points(60))
        return;
    drawText(*ImGui::GetWindowDrawList(), Face::Strong, {(left + right - size.x) / 2, middle - size.y / 2},
             palette::text, shown);
}

} // namespace

float toolbarHeight()
{
    return points(44);
}

void drawToolbar(ExplorerState& state)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const bool withLabels = labelsFit(width);
    ImGui::SetCursorScreenPos(
        {start.x, ImGui::GetWindowPos().y + std::floor((toolbarHeight() - toolButtonHeight()) / 2)});
    drawOpenButton(state, withLabels);
    drawHistoryButtons(state);
    if (drawToolButton({Icon::Frame, "Frame", false, withLabels},
                       "Move the camera so that the object fills the view.  F"))
        state.requests.push_back({Kind::Frame, {}});
    if (drawToolButton({Icon::Turntable, "Turntable", state.turntable, withLabels},
                       "Turn the object under its lights.  T"))
        state.turntable = !state.turntable;
    bool& handles = state.preferences.showLightHandles;
    if (drawToolButton({Icon::Lights, "Handles", handles, withLabels},
                       "Show the handles of the lights; drag one to move its light.  H"))
        handles = !handles;
    bool& grabs = state.grab.on;
    if (drawToolButton(
            {Icon::Grab, "Grab", grabs, withLabels},
            "Take hold of light in the picture: drag a highlight and its light follows (R.V = 1 under the hand), "
            "drag its edge to change n, drag the terminator (N.L = 0). Arrow keys move it, too.  S"))
        grabs = !grabs;
    if (drawToolButton({Icon::Lens, "Lens", state.lens.has_value(), withLabels},
                       "Paint the digits that float, half, SIMD or GL keep of double over the picture.  L"))
        state.lens = state.lens ? std::nullopt : std::optional(LensKind::Float);
    if (drawToolButton(
            {Icon::Compare, "Compare", state.compare.on, withLabels},
            "Compare two surfaces, A and B, under one camera and the same lights.  C.  B shows clay: Lambert beside "
            "Oren-Nayar."))
        toggleCompare(state.compare, state.scene);
    if (drawToolButton({Icon::Camera, "Picture", false, withLabels},
                       "Save a picture of the view.  F12.  Ctrl+F12 saves the whole window."))
        state.requests.push_back({Kind::SaveView, {}});
    if (drawToolButton({Icon::Reset, "Reset", false, withLabels}, "Back to the scene that the program opens with."))
        state.requests.push_back({Kind::ResetScene, {}});
    const float middle = ImGui::GetWindowPos().y + toolbarHeight() / 2;
    const float left = ImGui::GetCursorScreenPos().x;
    const float helpLeft =
        start.x + width - toolButtonWidth("Help", withLabels) - toolButtonWidth("Tour", withLabels) - points(2);
    drawTitle(state, left, helpLeft, middle);
    ImGui::SetCursorScreenPos({helpLeft, ImGui::GetCursorScreenPos().y});
    const bool touring = state.guide.number > 0;
    if (drawToolButton({Icon::Tour, "Tour", touring, withLabels},
                       "A guided tour: twelve short steps from Lambert to the trade, half an hour in all.  G"))
        state.requests.push_back({touring ? Kind::LeaveCase : Kind::ShowTour, {}});
    if (drawToolButton({Icon::Help, "Help", state.showHelp, withLabels}, "Gestures and keys.  F1"))
        state.showHelp = !state.showHelp;
    ImGui::NewLine();
}

} // namespace reflectance::explorer
