// Where in a list of numbers a share of them lies.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace reflectance {

/// The number at a share (0 .. 1) of the sorted list, in a straight line between its neighbours; 0 of none.
[[nodiscard]] inline double quantileOf(std::vector<double> numbers, double share)
{
    if (numbers.empty())
        return 0.0;
    const double place = share * static_cast<double>(numbers.size() - 1);
    const auto below = numbers.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(numbers.begin(), below, numbers.end());
    const double rest = place - std::floor(place);
    if (rest == 0.0)
        return *below;
    const double above = *std::min_element(below + 1, numbers.end());
    return above == *below ? above : *below + rest * (above - *below); // two infinities have no difference
}

/// Half of the numbers lie on either side; 0 of none.
[[nodiscard]] inline double medianOf(std::vector<double> numbers)
{
    return quantileOf(std::move(numbers), 0.5);
}

/// The smallest of the numbers that at least `share` (above 0, to 1) of them do not exceed; 0 of none.
[[nodiscard]] inline double leastCovering(std::vector<double> numbers, double share)
{
    if (numbers.empty())
        return 0.0;
    // A hair less, for 0.95 of 100 may come out above 95.
    const double rank = std::ceil(share * static_cast<double>(numbers.size()) * (1.0 - 1e-12)) - 1.0;
    const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 0.0));
    std::nth_element(numbers.begin(), place, numbers.end());
    return *place;
}

} // namespace reflectance
