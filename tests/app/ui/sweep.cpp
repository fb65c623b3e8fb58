#include "tests/app/ui/sweep.h"

#include <algorithm>
#include <map>
#include <utility>

namespace reflectance::explorer {

namespace {

using Cell = std::pair<int, int>;
using Grid = std::map<Cell, ImGuiID>;

/// A control is a rectangle: every point within the bounds of its points must be its own.
std::vector<Cell> strangersWithin(const Grid& grid, const std::vector<Cell>& cells, ImGuiID id)
{
    Cell low = cells.front(), high = cells.front();
    for (const auto& [x, y] : cells) {
        low = {std::min(low.first, x), std::min(low.second, y)};
        high = {std::max(high.first, x), std::max(high.second, y)};
    }
    for (int y = low.second; y <= high.second; ++y)
        for (int x = low.first; x <= high.first; ++x)
            if (grid.at({x, y}) != id)
                return {{x, y}};
    return {};
}

} // namespace

Faults sweep(Stage& stage, ImVec2 from, ImVec2 to, ImVec2 step, const Stage::Draw& draw)
{
    Grid grid;
    std::map<ImGuiID, std::vector<Cell>> controls;
    Faults faults;
    const auto pointOf = [&](Cell cell) {
        return ImVec2{from.x + step.x * static_cast<float>(cell.first),
                      from.y + step.y * static_cast<float>(cell.second)};
    };
    for (Cell cell{0, 0}; pointOf(cell).y < to.y; ++cell.second) {
        for (cell.first = 0; pointOf(cell).x < to.x; ++cell.first) {
            stage.moveTo(pointOf(cell));
            stage.frame(draw);
            const ImGuiID id = Stage::hovered();
            grid[cell] = id;
            if (id == 0)
                continue;
            const bool isNew = !controls.contains(id);
            controls[id].push_back(cell);
            for (int rest = 0; isNew && rest < 12; ++rest) // 0.6 s: longer than a tooltip waits
                stage.frame(draw);
            if (isNew && !Stage::showsTooltip())
                faults.silent.push_back(pointOf(cell));
        }
        cell.first = 0;
    }
    for (const auto& [id, cells] : controls)
        for (const Cell& cell : strangersWithin(grid, cells, id))
            faults.shared.push_back(pointOf(cell));
    faults.controls = controls.size();
    return faults;
}

} // namespace reflectance::explorer
