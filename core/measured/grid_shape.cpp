#include "core/measured/grid_shape.h"

#include <algorithm>
#include <numbers>

namespace reflectance {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

double largestStep(const std::vector<double>& axis)
{
    double largest = 0.0;
    for (std::size_t i = 1; i < axis.size(); ++i)
        largest = std::max(largest, axis[i] - axis[i - 1]);
    return largest;
}

} // namespace

Table reordered(const Table& table, const std::vector<std::size_t>& order)
{
    if (std::is_sorted(order.begin(), order.end()))
        return table;
    const std::size_t rank = table.axes.size();
    std::vector<std::size_t> stride(rank, table.channels); // of the old axes
    for (std::size_t axis = rank - 1; axis-- > 0;)
        stride[axis] = stride[axis + 1] * table.axes[axis + 1].size();
    Table result = table;
    for (std::size_t axis = 0; axis < rank; ++axis)
        result.axes[axis] = table.axes[order[axis]];
    for (std::size_t sample = 0; sample < table.samples(); ++sample) {
        std::size_t rest = sample;
        std::size_t from = 0;
        for (std::size_t axis = rank; axis-- > 0;) {
            from += rest % result.axes[axis].size() * stride[order[axis]];
            rest /= result.axes[axis].size();
        }
        std::copy_n(&table.values[from], table.channels, &result.values[sample * table.channels]);
    }
    return result;
}

Table closedAround(Table table)
{
    if (table.system != AngleSystem::Isotropic && table.system != AngleSystem::Specular)
        return table;
    auto& azimuths = table.axes[2];
    const double gap = turn - azimuths.back();
    const bool isHalf = azimuths.back() <= std::numbers::pi + 1e-9;
    if (isHalf || azimuths.front() != 0.0 || gap < 1e-9 || gap > largestStep(azimuths) * (1.0 + 1e-9))
        return table;
    std::vector<double> values;
    const std::size_t row = azimuths.size() * table.channels;
    for (auto at = table.values.begin(); at != table.values.end(); at += static_cast<std::ptrdiff_t>(row)) {
        values.insert(values.end(), at, at + static_cast<std::ptrdiff_t>(row));
        values.insert(values.end(), at, at + static_cast<std::ptrdiff_t>(table.channels));
    }
    table.values = std::move(values);
    azimuths.push_back(turn);
    return table;
}

} // namespace reflectance
