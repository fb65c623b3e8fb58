#include "app/explorer/ui/workbench/balls_view.h"

#include "app/explorer/ui/plot_canvas.h"
#include "app/explorer/ui/savable_plot.h"
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

namespace {

constexpr float smallestBall = 64.0F;

/// Rows and columns of balls in an area, and the side of each, its name below it included.
struct Arrangement {
    int columns = 1;
    float side = 1.0F;
    ImVec2 topLeft;

    [[nodiscard]] ImVec2 at(std::size_t index) const
    {
        const auto row = static_cast<float>(static_cast<int>(index) / columns);
        const auto column = static_cast<float>(static_cast<int>(index) % columns);
        return {topLeft.x + column * side, topLeft.y + row * (side + points(16))};
    }
};

/// So that balls are as large as they can be.
Arrangement arranged(std::size_t count, ImVec2 topLeft, ImVec2 size)
{
    Arrangement best;
    best.side = 0.0F;
    const int all = static_cast<int>(std::max<std::size_t>(1, count));
    for (int columns = 1; columns <= all; ++columns) {
        const int rows = (all + columns - 1) / columns;
        const float side = std::min((size.x - points(8)) / static_cast<float>(columns),
                                    (size.y - points(8)) / static_cast<float>(rows) - points(16));
        const float high = static_cast<float>(rows) * (side + points(16));
        if (side > best.side)
            best = {columns,
                    side,
                    {topLeft.x + (size.x - side * static_cast<float>(columns)) / 2, topLeft.y + (size.y - high) / 2}};
    }
    return best;
}

std::vector<NamedSurface> surfacesOf(const PlotAnswer& answer)
{
    std::vector<NamedSurface> surfaces = named(answer.question.surfaces);
    if (answer.question.tab != PlotTab::Wedge)
        return surfaces;
    const Parameter* parameter = surfaces.front().model->text.find(answer.question.parameter);
    return parameter ? wedgeOf(surfaces.front(), *parameter, answer.question.steps) : std::vector<NamedSurface>();
}

void drawBall(ImDrawList& list, const BallStrip& strip, std::size_t i, unsigned texture, ImVec2 at, float side)
{
    const auto count = static_cast<float>(strip.balls.size());
    const float inner = side - points(4);
    if (texture != 0)
        list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), at,
                      {at.x + inner, at.y + inner}, {static_cast<float>(i) / count, 0.0F},
                      {static_cast<float>(i + 1) / count, 1.0F});
    else
        list.AddRect(at, {at.x + inner, at.y + inner}, palette::line);
    const Ball& ball = strip.balls[i];
    ImGui::PushFont(face(Face::Small));
    const std::string name = elided(ball.name, inner);
    ImGui::PopFont();
    const float width = sizeIn(Face::Small, name).x;
    const float middle = at.x + inner / 2;
    plotText(list, middle, at.y + inner + points(9), TextAnchor::Centre, name, palette::text);
    list.AddLine({middle - width / 2, at.y + inner + points(17)}, {middle + width / 2, at.y + inner + points(17)},
                 onDark(ball.color), points(2));
}

std::string angleText(const Vec3d& A, const Vec3d& B)
{
    return general(degrees(std::atan2(length(cross(A, B)), dot(A, B))), 3) + "\u00B0";
}

/// Every ball's value at the same place as that under the mouse.
void readBalls(const PlotAnswer& answer, const Vec3d& N, const CurveSettings& settings)
{
    const std::vector<BallLight>& lights = answer.question.lights;
    CurveSettings channel = settings;
    channel.quantity = Quantity::Factor;
    std::vector<PlotEntry> entries;
    for (const NamedSurface& surface : surfacesOf(answer))
        entries.push_back({onDark(surface.color),
                           general(numberOf(radianceOf(surface, lights, N), 1.0, channel), 5) + "  " + surface.name});
    const std::string light = lights.empty() ? "no light" : "\u03B8_i = " + angleText(N, normalized(lights.front().L));
    showReading("factor \u00D7 light;  " + light + ", \u03B8_r = " + angleText(N, {0, 0, 1}), entries);
}

} // namespace

Vec3d radianceOf(const NamedSurface& surface, const std::vector<BallLight>& lights, const Vec3d& N)
{
    Observation row{N, {0, 0, 1}, {}};
    for (const BallLight& light : lights)
        row.lights.push_back({light.L, light.I, surface.model->text.usesLightSize ? std::max(light.radius, 5.0) : 0.0});
    return evaluate(*surface.model, surface.values, {&row, 1}, Precision::Double, surface.measured)[0];
}

void drawBalls(const char* id, const PlotAnswer& answer, unsigned texture, ImVec2 size, ExplorerState& state)
{
    const BallStrip& strip = answer.balls;
    ImGui::BeginGroup();
    plotHeading({id, strip.title, [&] { return svgOf(strip, 900, 240); }, [&] { return csvOf(strip); }}, size, state);
    const PlotArea area = plotArea(id, {size.x, size.y - plotHeadingHeight()});
    const Arrangement places = arranged(strip.balls.size(), area.topLeft, area.size);
    std::optional<Vec3d> N;
    if (places.side >= points(smallestBall) / 2) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const auto inner = static_cast<double>(places.side - points(4));
        for (std::size_t i = 0; i < strip.balls.size(); ++i) {
            const ImVec2 at = places.at(i);
            drawBall(list, strip, i, texture, at, places.side);
            if (const auto under = normalAt(2.0 * static_cast<double>(mouse.x - at.x) / inner - 1.0,
                                            1.0 - 2.0 * static_cast<double>(mouse.y - at.y) / inner);
                under && area.hovered)
                N = under;
        }
    }
    if (N)
        readBalls(answer, *N, state.curves.settings);
    else
        tooltip("Move the mouse over a ball to read every ball's value at that place.");
    ImGui::EndGroup();
}

} // namespace reflectance::explorer
