#include "core/base/text.h"
#include "core/chart/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// The smallest of 1, 2, 5, 10 times a power of ten that is not below `least`.
double roundStep(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - 1e-9))
            return factor * power;
    return 10.0 * power;
}

/// Powers of ten are written as such where they would be long.
std::string logText(double value)
{
    const double exponent = std::log10(value);
    const bool isPower = std::fabs(exponent - std::round(exponent)) < 1e-9;
    if (isPower && std::fabs(exponent) > 2.5)
        return "1e" + std::to_string(std::lround(exponent));
    return general(value, 3);
}

std::vector<Tick> linearTicks(const Axis& axis, int most)
{
    std::vector<Tick> ticks;
    const double length = axis.high - axis.low;
    if (!(length > 0.0) || !std::isfinite(length))
        return ticks;
    const double slack = 1e-9 * length;
    const auto first = [&](double step) { return std::ceil((axis.low - slack) / step); };
    const auto last = [&](double step) { return std::floor((axis.high + slack) / step); };
    double step = axis.step > 0.0 ? axis.step : roundStep(length / std::max(2, most));
    while (last(step) - first(step) + 1.0 > std::max(2, most))
        step = axis.step > 0.0 ? 2.0 * step : roundStep(1.5 * step);
    for (double k = first(step); k <= last(step); ++k) {
        const double value = k == 0.0 ? 0.0 : k * step;
        ticks.push_back({value, general(value, 6)});
    }
    return ticks;
}

std::vector<Tick> logTicks(const Axis& axis, int most)
{
    std::vector<Tick> ticks;
    if (!(axis.low > 0.0) || !(axis.high > axis.low))
        return ticks;
    const int first = static_cast<int>(std::ceil(std::log10(axis.low) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(axis.high) + 1e-9));
    const int decades = last - first + 1;
    if (3 * decades <= most || decades < 2) {
        for (int e = first - 1; e <= last; ++e)
            for (const double factor : {1.0, 2.0, 5.0})
                if (const double value = factor * std::pow(10.0, e);
                    value >= axis.low * (1.0 - 1e-9) && value <= axis.high * (1.0 + 1e-9))
                    ticks.push_back({value, logText(value)});
        return ticks.size() >= 2 ? ticks : linearTicks(axis, most);
    }
    const int stride = (decades + std::max(2, most) - 1) / std::max(2, most);
    for (int e = first; e <= last; e += stride)
        ticks.push_back({std::pow(10.0, e), logText(std::pow(10.0, e))});
    return ticks;
}

} // namespace

ChartColor seriesColor(std::size_t index)
{
    constexpr std::array<ChartColor, 7> colors = {0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0x8C7A00};
    return colors[index % colors.size()];
}

double shareAlong(const Axis& axis, double value)
{
    if (axis.scale == AxisScale::Linear)
        return (value - axis.low) / (axis.high - axis.low);
    if (!(value > 0.0))
        return std::numeric_limits<double>::quiet_NaN();
    return std::log(value / axis.low) / std::log(axis.high / axis.low);
}

double valueAlong(const Axis& axis, double share)
{
    if (axis.scale == AxisScale::Linear)
        return axis.low + share * (axis.high - axis.low);
    return axis.low * std::pow(axis.high / axis.low, share);
}

Axis axisAround(std::string label, const std::vector<double>& numbers, AxisScale scale)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double number : numbers)
        if (std::isfinite(number) && (scale == AxisScale::Linear || number > 0.0)) {
            low = std::min(low, number);
            high = std::max(high, number);
        }
    if (!(low <= high))
        return {std::move(label), scale == AxisScale::Log ? 0.1 : 0.0, 1.0, scale};
    if (scale == AxisScale::Log) {
        const double margin = low < high ? std::pow(high / low, 0.05) : 2.0;
        return {std::move(label), low / margin, high * margin, scale};
    }
    const double margin = low < high ? 0.05 * (high - low) : std::max(0.5 * std::fabs(low), 0.5);
    return {std::move(label), low - margin, high + margin, scale};
}

std::vector<Tick> ticksOf(const Axis& axis, int most)
{
    return axis.scale == AxisScale::Log ? logTicks(axis, most) : linearTicks(axis, most);
}

} // namespace reflectance
