#include "core/measured/bilinear.h"

#include <algorithm>
#include <utility>

namespace reflectance {
namespace {

struct Cell {
    std::size_t index;
    double t;
};

Cell cellAt(double x, std::size_t nodes)
{
    const double place = std::clamp(x, 0.0, 1.0) * static_cast<double>(nodes - 1);
    const std::size_t index = std::min(static_cast<std::size_t>(place), nodes - 2);
    return {index, place - static_cast<double>(index)};
}

double mixed(double a, double b, double t)
{
    return a + t * (b - a);
}

/// Integral from 0 to t of the straight line from a to b.
double underLine(double a, double b, double t)
{
    return t * (a + 0.5 * t * (b - a));
}

} // namespace

double BilinearGrid::at(double x, double y) const
{
    const auto [i, s] = cellAt(x, width);
    const auto [j, t] = cellAt(y, height);
    const float* const low = &nodes[j * width + i];
    const float* const high = low + width;
    return mixed(mixed(low[0], low[1], s), mixed(high[0], high[1], s), t);
}

WarpedSquare::WarpedSquare(BilinearGrid density) : density_(std::move(density))
{
    const double dx = 1.0 / static_cast<double>(density_.width - 1);
    const double dy = 1.0 / static_cast<double>(density_.height - 1);
    double row = 0.0;
    for (std::size_t j = 0; j < density_.height; ++j) {
        double sum = 0.0;
        for (std::size_t i = 0; i < density_.width; ++i) {
            const float* const node = &density_.nodes[j * density_.width + i];
            sum += i > 0 ? 0.5 * dx * (double{node[-1]} + node[0]) : 0.0;
            leftOfNode_.push_back(sum);
        }
        belowRow_.push_back(j > 0 ? belowRow_.back() + 0.5 * dy * (row + sum) : 0.0);
        row = sum;
    }
}

double WarpedSquare::leftOf(double x, double y) const
{
    const auto [i, s] = cellAt(x, density_.width);
    const auto [j, t] = cellAt(y, density_.height);
    const double dx = 1.0 / static_cast<double>(density_.width - 1);
    const auto alongRow = [&, i = i, s = s](std::size_t row) {
        const std::size_t node = row * density_.width + i;
        return leftOfNode_[node] + dx * underLine(density_.nodes[node], density_.nodes[node + 1], s);
    };
    return mixed(alongRow(j), alongRow(j + 1), t);
}

double WarpedSquare::across(double y) const
{
    const auto [j, t] = cellAt(y, density_.height);
    const std::size_t end = density_.width - 1;
    return mixed(leftOfNode_[j * density_.width + end], leftOfNode_[(j + 1) * density_.width + end], t);
}

double WarpedSquare::below(double y) const
{
    const auto [j, t] = cellAt(y, density_.height);
    const std::size_t end = density_.width - 1;
    const double low = leftOfNode_[j * density_.width + end];
    const double high = leftOfNode_[(j + 1) * density_.width + end];
    return belowRow_[j] + underLine(low, high, t) / static_cast<double>(density_.height - 1);
}

} // namespace reflectance
