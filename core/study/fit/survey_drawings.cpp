#include "core/math/quantile.h"
#include "core/study/fit/survey_page.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reflectance {
namespace {

constexpr ChartColor paleColor = 0x909090;

double leastError(const SurveyedSurface& surface)
{
    double least = HUGE_VAL;
    for (const auto& fit : surface.fits)
        if (fit)
            least = std::min(least, fit->relativeRms);
    return least;
}

/// A staircase: how many errors lie within each tolerance.
Series servedSeries(const std::string& name, std::vector<double> errors, double from, double to)
{
    Series series{name, paleColor, {from}, {0.0}, {}, Mark::Line, true, false, {}};
    std::sort(errors.begin(), errors.end());
    double count = static_cast<double>(std::count_if(errors.begin(), errors.end(), [&](double e) { return e < from; }));
    series.y.front() = count;
    for (const double error : errors) {
        if (!(error >= from && error <= to))
            continue;
        series.x.insert(series.x.end(), {error, error});
        series.y.insert(series.y.end(), {count, count + 1.0});
        count += 1.0;
    }
    series.x.push_back(to);
    series.y.push_back(count);
    return series;
}

void pickOut(Series& series, std::size_t& colors)
{
    series.color = seriesColor(colors++);
    series.faint = false;
}

/// The question's two models, and of the others the two with the smallest median error.
std::vector<std::string> pickedOut(const Survey& survey)
{
    std::vector<std::string> others;
    for (const FittedModel& candidate : survey.candidates)
        if (candidate.label != "lambert" && candidate.label != "hybrid")
            others.push_back(candidate.label);
    std::stable_sort(others.begin(), others.end(), [&](const std::string& a, const std::string& b) {
        return medianOf(errorsOf(survey, a)) < medianOf(errorsOf(survey, b));
    });
    others.resize(std::min<std::size_t>(others.size(), 2));
    std::vector<std::string> picked{"lambert", "hybrid"};
    picked.insert(picked.end(), others.begin(), others.end());
    return picked;
}

Chart servedChart(const Survey& survey, double tolerance)
{
    constexpr double from = 0.01, to = 1.0;
    Chart chart{"Surfaces that a model serves",
                {"relative RMS error that is tolerated", from, to, AxisScale::Log},
                {"surfaces", 0.0, static_cast<double>(survey.surfaces.size()), AxisScale::Linear},
                {},
                {{tolerance, true, "tolerance"}}};
    std::size_t colors = 0;
    const std::vector<std::string> picked = pickedOut(survey);
    for (const FittedModel& candidate : survey.candidates)
        if (std::find(picked.begin(), picked.end(), candidate.label) == picked.end())
            chart.series.push_back(servedSeries("", errorsOf(survey, candidate.label), from, to));
    for (const std::string& label : picked) {
        chart.series.push_back(servedSeries(label, errorsOf(survey, label), from, to));
        pickOut(chart.series.back(), colors);
    }
    return chart;
}

/// Surfaces in the order of Lambert's error.
std::vector<std::size_t> orderByLambert(const Survey& survey)
{
    const std::vector<double> lambert = errorsOf(survey, "lambert");
    std::vector<std::size_t> order(lambert.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lambert[a] < lambert[b]; });
    return order;
}

Series dots(const std::string& name, const std::vector<double>& values, const std::vector<std::size_t>& order,
            std::size_t& colors)
{
    Series series{name, seriesColor(colors++), {}, {}, {}, Mark::Dots, false, false, {}};
    for (std::size_t rank = 0; rank < order.size() && !values.empty(); ++rank) {
        series.x.push_back(static_cast<double>(rank + 1));
        series.y.push_back(values[order[rank]]);
    }
    return series;
}

Chart surfacesChart(const Survey& survey, double tolerance)
{
    std::vector<double> least;
    for (const SurveyedSurface& surface : survey.surfaces)
        least.push_back(leastError(surface));
    const std::vector<double> lambert = errorsOf(survey, "lambert");
    std::vector<double> all = lambert;
    all.insert(all.end(), least.begin(), least.end());
    Chart chart{"Each surface under three models",
                {"surface, ordered by Lambert's error", 0.0, static_cast<double>(survey.surfaces.size() + 1),
                 AxisScale::Linear},
                axisAround("relative RMS error", all, AxisScale::Log),
                {},
                {{tolerance, false, "tolerance"}}};
    std::size_t colors = 0;
    const std::vector<std::size_t> order = orderByLambert(survey);
    chart.series = {dots("lambert", lambert, order, colors), dots("hybrid", errorsOf(survey, "hybrid"), order, colors),
                    dots("the best of all", least, order, colors)};
    return chart;
}

Chart costChart(const Survey& survey)
{
    Series models{"", seriesColor(0), {}, {}, {}, Mark::Dots, false, false, {}};
    for (const FittedModel& candidate : survey.candidates) {
        models.x.push_back(candidate.nsSimd);
        models.y.push_back(medianOf(errorsOf(survey, candidate.label)));
        models.labels.push_back(candidate.label);
    }
    Axis cost = axisAround("nanoseconds per evaluation, in SIMD lanes", models.x, AxisScale::Log);
    cost.high *= 1.6; // room for the names beside the last dots
    const Axis error = axisAround("median relative RMS error", models.y, AxisScale::Log);
    return {"What accuracy costs", cost, error, {models}, {}};
}

} // namespace

std::vector<Drawing> drawingsOf(const Survey& survey, double tolerance)
{
    return {{"served", "How many surfaces each model serves, for every tolerance. Pale: the other models.",
             servedChart(survey, tolerance)},
            {"surfaces", "Every surface: how far Lambert, the hybrid and the best of all models are off.",
             surfacesChart(survey, tolerance)},
            {"cost", "What each model costs, and how far it is off on the median surface.", costChart(survey)}};
}

} // namespace reflectance
