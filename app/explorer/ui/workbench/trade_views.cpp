#include "app/explorer/ui/workbench/trade_views.h"

#include "app/explorer/ui/numerals.h"
#include "app/explorer/ui/savable_plot.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/study/trade/trade_chart.h"
#include "core/study/trade/trade_page.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {
namespace {

/// The candidate whose dot is within reach of the mouse.
std::optional<std::size_t> candidateAt(const Trade& trade, const Chart& chart, const PlotHover& hover, ImVec2 size)
{
    std::optional<std::size_t> nearest;
    double least = static_cast<double>(points(9));
    for (std::size_t i = 0; i < trade.candidates.size(); ++i) {
        if (trade.candidates[i].shade.repetitions == 0)
            continue;
        const ChartPoint at = pointOf(trade, trade.candidates[i]);
        const double across =
            (shareAlong(chart.x, at.cost) - shareAlong(chart.x, hover.x)) * static_cast<double>(size.x);
        const double up = (shareAlong(chart.y, at.error) - shareAlong(chart.y, hover.y)) * static_cast<double>(size.y);
        // Of dots that lie on one another the front's is meant.
        const double distance = std::hypot(across, up) + (trade.candidates[i].onFront ? 0.0 : 0.5);
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

void dragTolerance(TradeStudy& study, const Chart& chart, const PlotHover& hover, float height)
{
    if (study.byTime)
        return;
    const double away =
        (shareAlong(chart.y, study.tolerance) - shareAlong(chart.y, hover.y)) * static_cast<double>(height);
    const bool near = hover.inside && std::fabs(away) < static_cast<double>(points(6));
    if (near && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        study.holdsTolerance = true;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left))
        study.holdsTolerance = false;
    if (near || study.holdsTolerance)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    if (study.holdsTolerance && hover.inside) {
        study.tolerance = std::clamp(hover.y, 1e-9, 1e3);
        study.selected.reset();
    }
}

void line(const char* name, const std::string& value, const char* about)
{
    const float start = ImGui::GetCursorPosX();
    remark(name);
    tooltip(about);
    ImGui::SameLine();
    ImGui::SetCursorPosX(start + points(118));
    remark(value, palette::text);
}

/// A bar from the left, `share` of the width that is left.
void bar(double share, ImU32 color, const std::string& text)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    const float width = std::max(0.0F, ImGui::GetContentRegionAvail().x);
    const float labelWidth = std::max(points(84), sizeIn(Face::Small, text).x + points(8));
    const float length = std::max(1.0F, static_cast<float>(std::clamp(share, 0.0, 1.0)) * (width - labelWidth));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(start, {start.x + length, start.y + height * 0.8F}, color, points(2));
    drawText(list, Face::Small, {start.x + length + points(6), start.y}, palette::text, text);
    ImGui::Dummy({width, height});
}

} // namespace

void drawTradeChart(ExplorerState& state, ImVec2 whole)
{
    TradeStudy& study = state.trade;
    const Trade& trade = *study.trade;
    Chart chart = chartOf(trade, study.byTime ? std::optional<double>() : study.tolerance, false);
    if (study.byTime)
        chart.guides.push_back({study.milliseconds, true, "budget"});
    if (const auto shown = study.shown()) {
        const ChartPoint at = pointOf(trade, trade.candidates[*shown]);
        Series ring;
        ring.name = study.selected ? "selected" : "the dial's choice";
        ring.color = seriesColor(4);
        ring.mark = Mark::Dots;
        ring.x = {at.cost};
        ring.y = {at.error};
        chart.series.push_back(ring);
    }
    const ImVec2 size{whole.x, whole.y - plotHeadingHeight()};
    const PlotHover hover = savablePlot("trade", chart, whole, state);
    dragTolerance(study, chart, hover, size.y);
    if (!hover.inside || study.holdsTolerance)
        return;
    if (const auto near = candidateAt(trade, chart, hover, size)) {
        beginTooltip();
        remark(sentenceOf(trade, trade.candidates[*near]), palette::text);
        remark("Click to look at it.");
        endTooltip();
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
            study.selected = near;
    }
}

void drawTradeCandidate(const TradeStudy& study)
{
    const auto shown = study.shown();
    if (!shown) {
        const Trade& trade = *study.trade;
        const Candidate* best = study.byTime ? cheapest(trade) : mostExact(trade);
        remark("Nothing measured meets that.", palette::warning, Face::Body);
        if (best)
            remark("The best that can be had is " + sentenceOf(trade, *best) + ".");
        return;
    }
    const Candidate& c = study.trade->candidates[*shown];
    remark(nameOf(c.recipe), palette::text, Face::Strong);
    remark("It " + givenUp(c.recipe) + ".");
    line("largest error", general(c.error.max, 3), "Largest difference of a linear channel to the truth; white is 1.");
    line("RMSE", general(c.error.rmse, 3), "Root mean square over all channels of the whole picture, linear.");
    line("dE2000", general(c.error.perceived.deltaEP95, 3) + ", at most " + general(c.error.perceived.deltaEMax, 3),
         "Over the object's pixels as a display shows them: 95 of 100 are below the first figure.");
    line("FLIP", general(c.error.perceived.flipMean, 3), "Mean over the picture, 67 pixels per degree; 0 to 1.");
    line("shading again", general(c.shade.median, 3) + " ms \u00B1 " + general(c.shade.spread, 2),
         "What a dragged light costs: median and half the distance of the quartiles.");
    line("first picture", general(c.cost(Cost::FirstFrame), 3) + " ms", "Looking and shading; the mesh is in place.");
    line("kept", general(static_cast<double>(c.bytes) / 1e6, 3) + " MB", "Between two shadings, besides the mesh.");
    if (c.kernelNs)
        line("one shading", general(*c.kernelNs, 3) + " ns", "Per direction and light, caches warm, one core.");
    if (c.bound)
        line("promised change", "\u2264 " + general(*c.bound, 3) + ", found " + general(c.change, 3),
             "What its rung promises from the scene alone, and what was measured.");
}

void drawTradeTerms(const TradeStudy& study)
{
    if (!study.terms)
        return remark("The terms are measured after the candidates.");
    double mostSeen = 1e-9, mostTime = 1e-9;
    for (const TermFigures& term : study.terms->terms) {
        mostSeen = std::max(mostSeen, term.buys.perceived.deltaEP95);
        mostTime = std::max(mostTime, term.milliseconds);
    }
    remark("All terms: " + general(study.terms->whole.median, 3) + " ms in SIMD. Each buys dE2000 (p95) and costs ms:");
    for (const TermFigures& term : study.terms->terms) {
        remark(term.name, palette::text);
        tooltip("Without it: RMSE " + general(term.buys.rmse, 3) + ", largest dE2000 " +
                general(term.buys.perceived.deltaEMax, 3) + "; it costs " + general(term.milliseconds, 3) + " \u00B1 " +
                general(term.spread, 2) + " ms.");
        bar(term.buys.perceived.deltaEP95 / mostSeen, onDark(seriesColor(0)),
            general(term.buys.perceived.deltaEP95, 3) + " dE, RMSE " + general(term.buys.rmse, 2));
        bar(term.milliseconds / mostTime, onDark(seriesColor(1)), general(term.milliseconds, 2) + " ms");
    }
}

void drawMapLegend(const SufficientMap& map)
{
    std::size_t all = 0;
    for (const SufficientModel& model : map.models)
        all += model.pixels;
    for (const SufficientModel& model : map.models) {
        if (model.pixels == 0)
            continue;
        const ImVec2 start = ImGui::GetCursorScreenPos();
        const float side = points(11);
        const ImU32 ink = IM_COL32(model.color >> 16 & 0xFFU, model.color >> 8 & 0xFFU, model.color & 0xFFU, 255);
        ImGui::GetWindowDrawList()->AddRectFilled(start, {start.x + side, start.y + side}, ink);
        ImGui::Dummy({side, side});
        ImGui::SameLine();
        const double share =
            100.0 * static_cast<double>(model.pixels) / static_cast<double>(std::max<std::size_t>(1, all));
        remark(general(share, 3) + " %  " + (model.recipe.rungs.empty() ? "the whole surface" : nameOf(model.recipe)),
               palette::text);
        tooltip("One shading takes " + general(model.nanoseconds, 3) + " ns in SIMD; " + grouped(model.pixels) +
                " pixels need no more.");
    }
}

} // namespace reflectance::explorer
