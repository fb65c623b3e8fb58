#include "app/explorer/ui/row_list.h"

#include "app/explorer/ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace reflectance::explorer {

std::optional<std::size_t> rowList(const char* id, std::size_t count, const char* more,
                                   const std::function<bool(std::size_t)>& drawRow)
{
    constexpr std::size_t rowsShown = 5;
    const auto rows = static_cast<float>(std::min(count, rowsShown));
    std::optional<std::size_t> removed;
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, 0.0F);
    ImGui::BeginChild(id, {0, rows * ImGui::GetFrameHeightWithSpacing()});
    for (std::size_t i = 0; i < count; ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (drawRow(i))
            removed = i;
        ImGui::PopID();
    }
    scrollBarTooltip(more);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    return removed;
}

} // namespace reflectance::explorer
