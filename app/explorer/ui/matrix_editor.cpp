#include "app/explorer/ui/matrix_editor.h"

#include "app/explorer/ui/matrix_modes.h"
#include "app/explorer/ui/parameter_rows.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

constexpr std::array<Choice, 3> modes = {{
    // in the order of MatrixMode
    {"scalar", "One number for all sensors: a grey surface. Going back restores the colours."},
    {"diagonal", "One number per sensor, as if the filters did not overlap: a cheat, and the usual one. "
                 "Off-diagonals are remembered."},
    {"full", "All nine numbers: the sensor's filters overlap, so each sensor sees something of every light primary."},
}};

constexpr std::array<const char*, 3> letters = {"R", "G", "B"};
constexpr std::array<const char*, 3> names = {"red", "green", "blue"};
constexpr std::array<ImU32, 3> inks = {IM_COL32(232, 132, 124, 255), IM_COL32(136, 198, 136, 255),
                                       IM_COL32(132, 170, 240, 255)};

bool drawModes(MatrixValues& K, MatrixMemory& memory)
{
    const int pressed = choiceRow(modes, static_cast<int>(modeOf(K, memory)));
    if (pressed < 0)
        return false;
    const MatrixValues before = K;
    K = switched(K, static_cast<MatrixMode>(pressed), memory);
    return K != before;
}

void centredLetter(ImVec2 topLeft, float width, float height, std::string_view text, ImU32 color, Face which)
{
    const ImVec2 size = sizeIn(which, text);
    drawText(*ImGui::GetWindowDrawList(), which, {topLeft.x + (width - size.x) / 2, topLeft.y + (height - size.y) / 2},
             color, text);
}

NumberRow cellRow(const Parameter& parameter, std::size_t row, std::size_t column)
{
    NumberRow cell = rowOf(parameter, 3 * row + column);
    cell.name = std::string("K") + letters[row] + letters[column];
    cell.label = parameter.symbol + ", " + names[row] + " sensor, " + names[column] + " light";
    cell.about =
        std::string("How much of the light's ") + names[column] + " primary the " + names[row] + " sensor sees.";
    return cell;
}

/// Geometry of the grid: a column of letters, three of cells, one of row sums.
struct Grid {
    float letter, cell, sum, gap;
};

Grid gridFor(float width)
{
    Grid grid{points(20), 0, points(50), points(4)};
    grid.cell = (width - grid.letter - grid.sum - 3 * grid.gap) / 3;
    return grid;
}

void drawColumnLetters(const Grid& grid)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = points(18);
    for (std::size_t column = 0; column < 3; ++column) {
        const float x = start.x + grid.letter + static_cast<float>(column) * (grid.cell + grid.gap);
        centredLetter({x, start.y}, grid.cell, height, std::string(letters[column]) + " light", inks[column],
                      Face::Small);
    }
    const float sumLeft = start.x + grid.letter + 3 * (grid.cell + grid.gap);
    centredLetter({sumLeft, start.y}, grid.sum, height, "\u03A3 row", palette::quiet, Face::Small);
    ImGui::Dummy({1, height});
}

void drawRowSum(const Grid& grid, ImVec2 topLeft, double sum)
{
    ImGui::SetCursorScreenPos(topLeft);
    ImGui::Dummy({grid.sum, ImGui::GetFrameHeight()});
    tooltip("What this sensor gets under white light, with the surface facing it. Above 1 the surface is not passive.");
    centredLetter(topLeft, grid.sum, ImGui::GetFrameHeight(), general(sum, 3),
                  sum > 1.0 ? palette::warning : palette::quiet, Face::Body);
}

bool drawRow(const Parameter& parameter, std::size_t row, const Grid& grid, MatrixMode mode, MatrixValues& K,
             ExplorerState& state)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    centredLetter(start, grid.letter - points(4), height, letters[row], inks[row], Face::Strong);
    bool changed = false;
    for (std::size_t column = 0; column < 3; ++column) {
        const ImVec2 topLeft{start.x + grid.letter + static_cast<float>(column) * (grid.cell + grid.gap), start.y};
        if (mode == MatrixMode::Diagonal && row != column) {
            centredLetter(topLeft, grid.cell, height, "0", palette::quiet, Face::Body);
            continue;
        }
        ImGui::SetCursorScreenPos(topLeft);
        changed |= numberField(cellRow(parameter, row, column), K[3 * row + column], grid.cell, state.message);
    }
    drawRowSum(grid, {start.x + grid.letter + 3 * (grid.cell + grid.gap), start.y},
               K[3 * row] + K[3 * row + 1] + K[3 * row + 2]);
    return changed;
}

bool drawScalar(const Parameter& parameter, MatrixValues& K, ExplorerState& state)
{
    NumberRow row = rowOf(parameter, 0);
    row.label = "All channels";
    double value = K[0];
    if (!numberRow(row, value, state.message))
        return false;
    K = {value, 0, 0, 0, value, 0, 0, 0, value};
    return true;
}

bool drawGrid(const Parameter& parameter, MatrixMode mode, MatrixValues& K, ExplorerState& state)
{
    const Grid grid = gridFor(ImGui::GetContentRegionAvail().x);
    drawColumnLetters(grid);
    bool changed = false;
    for (std::size_t row = 0; row < 3; ++row)
        changed |= drawRow(parameter, row, grid, mode, K, state);
    return changed;
}

void drawConvention(Convention convention)
{
    remark("K is in the " + std::string(nameOf(convention)) + " convention.");
    tooltip(convention == Convention::Sensor
                ? "Lights are given as the sensor sees them on a perfect white: a grey surface has K = kd times the "
                  "identity."
                : "Lights are strengths of the primaries: even a grey surface has off-diagonals, K = kd W.");
}

void drawModeRemark(const MatrixValues& K, MatrixMode mode, const MatrixMemory& memory)
{
    const double dropped = offDiagonalShare(mode == MatrixMode::Full || !memory.wider ? K : *memory.wider);
    const std::string share = "\u03A3|off| / \u03A3|diag| = " + general(dropped, 3);
    if (mode == MatrixMode::Full)
        remark("A diagonal would drop " + share + ".");
    else if (dropped > 0.0)
        remark("A " + std::string(mode == MatrixMode::Diagonal ? "diagonal" : "scalar") +
                   " K is a cheat: it drops the overlap of the filters, " + share + ".",
               palette::warning);
    else if (mode == MatrixMode::Diagonal)
        remark("A diagonal K is a cheat: real filters overlap.", palette::warning);
}

} // namespace

bool matrixEditor(const Parameter& parameter, std::vector<double>& values, ExplorerState& state)
{
    ImGui::PushID(parameter.name.c_str());
    MatrixMemory& memory = state.panels.matrices[parameter.name];
    MatrixValues K;
    std::copy_n(values.begin(), 9, K.begin());
    rowLabel(parameter.symbol, parameter.label);
    bool changed = drawModes(K, memory);
    const MatrixMode mode = modeOf(K, memory);
    changed |= mode == MatrixMode::Scalar ? drawScalar(parameter, K, state) : drawGrid(parameter, mode, K, state);
    drawConvention(surfaceInHand(state.compare, state.scene).convention);
    drawModeRemark(K, mode, memory);
    for (const std::string& sentence : matrixRemarks(K))
        remark(sentence, palette::warning);
    if (changed)
        std::copy(K.begin(), K.end(), values.begin());
    ImGui::PopID();
    return changed;
}

} // namespace reflectance::explorer
