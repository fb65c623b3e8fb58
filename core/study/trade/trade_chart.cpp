#include "core/study/trade/trade_chart.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr ChartColor dominatedColor = 0x8C8C8C;
constexpr std::size_t cpuHue = 0, glHue = 1, currentHue = 2;

void append(const Trade& trade, const Candidate& candidate, Series& series)
{
    const ChartPoint at = pointOf(trade, candidate);
    series.x.push_back(at.cost);
    series.y.push_back(at.error);
    series.spreadX.push_back(candidate.shade.spread);
}

Series dots(std::string name, ChartColor color, bool faint)
{
    Series series;
    series.name = std::move(name);
    series.color = color;
    series.mark = Mark::Dots;
    series.faint = faint;
    return series;
}

/// The staircase's corners, joined.
Series frontLine(const Trade& trade)
{
    Series line;
    line.color = 0x606060;
    for (const std::size_t i : frontOf(trade)) {
        const ChartPoint at = pointOf(trade, trade.candidates[i]);
        line.x.push_back(at.cost);
        line.y.push_back(at.error);
    }
    return line;
}

/// Half the smallest error that is not 0, for those that are.
double errorFloor(const Trade& trade)
{
    double least = HUGE_VAL;
    for (const Candidate& candidate : trade.candidates)
        if (const double error = candidate.error.by(trade.metric); error > 0.0)
            least = std::min(least, error);
    return std::isfinite(least) ? least / 2.0 : 1e-9;
}

} // namespace

ChartPoint pointOf(const Trade& trade, const Candidate& candidate)
{
    return {std::max(candidate.cost(trade.cost), 1e-6), std::max(candidate.error.by(trade.metric), errorFloor(trade))};
}

Chart chartOf(const Trade& trade, std::optional<double> tolerance, bool labels)
{
    Chart chart;
    Series dominated = dots("dominated", dominatedColor, true);
    Series cpu = dots("front, CPU", seriesColor(cpuHue), false);
    Series gl = dots("front, GL", seriesColor(glHue), false);
    Series current = dots("what is drawn now", seriesColor(currentHue), false);
    for (std::size_t i = 0; i < trade.candidates.size(); ++i) {
        const Candidate& candidate = trade.candidates[i];
        if (candidate.shade.repetitions == 0)
            continue;
        Series& series = !candidate.onFront ? dominated : candidate.recipe.onGl() ? gl : cpu;
        append(trade, candidate, series);
        if (labels && candidate.onFront)
            series.labels.push_back(nameOf(candidate.recipe));
        if (trade.current == i)
            append(trade, candidate, current);
    }
    std::vector<double> costs, errors;
    for (const Series* series : {&dominated, &cpu, &gl}) {
        costs.insert(costs.end(), series->x.begin(), series->x.end());
        errors.insert(errors.end(), series->y.begin(), series->y.end());
    }
    if (tolerance && *tolerance > 0.0)
        errors.push_back(*tolerance);
    chart.x = axisAround(std::string(labelOf(trade.cost)), costs, AxisScale::Log);
    chart.y = axisAround(std::string(labelOf(trade.metric)), errors, AxisScale::Log);
    chart.series = {dominated, frontLine(trade), cpu, gl, current};
    if (tolerance && *tolerance > 0.0)
        chart.guides.push_back({*tolerance, false, "tolerance"});
    return chart;
}

} // namespace reflectance
