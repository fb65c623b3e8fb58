#include "tests/app/ui/stage.h"

#include "app/explorer/ui/ui.h"

#include <imgui_internal.h>

namespace reflectance::explorer {

Stage::Stage(float width, float height, float scale)
{
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {width, height};
    for (int key = 0; key < ImGuiKey_COUNT; ++key)
        io.KeyMap[key] = key;
    loadFonts(scale);
    applyTheme(scale);
}

Stage::~Stage()
{
    ImGui::DestroyContext();
}

void Stage::frame(const Draw& draw)
{
    ImGui::GetIO().DeltaTime = 0.05F;
    ImGui::NewFrame();
    draw();
    ImGui::Render();
}

void Stage::frameIn(ImVec2 place, ImVec2 size, const Draw& draw)
{
    frame([&] {
        ImGui::SetNextWindowPos(place);
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("stage", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        draw();
        ImGui::End();
    });
}

void Stage::moveTo(ImVec2 point)
{
    ImGui::GetIO().MousePos = point;
}

void Stage::click(ImVec2 point, const Draw& draw)
{
    moveTo(point);
    frame(draw);
    hold(true);
    frame(draw);
    hold(false);
    frame(draw);
}

void Stage::doubleClick(ImVec2 point, const Draw& draw)
{
    click(point, draw);
    click(point, draw);
}

void Stage::press(ImGuiKey_ key, const Draw& draw)
{
    ImGui::GetIO().KeysDown[key] = true;
    frame(draw);
    ImGui::GetIO().KeysDown[key] = false;
    frame(draw);
}

void Stage::type(const std::string& text, const Draw& draw)
{
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    frame(draw);
}

ImGuiID Stage::hovered()
{
    return ImGui::GetCurrentContext()->HoveredId;
}

bool Stage::showsTooltip()
{
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if (window->Active && (window->Flags & ImGuiWindowFlags_Tooltip) != 0)
            return true;
    return false;
}

} // namespace reflectance::explorer
