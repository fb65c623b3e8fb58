#include "core/image/upscale.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

/// The two coarse pixels around a fine one along an edge, and the second one's weight.
struct Between {
    int first = 0, second = 0;
    float weight = 0.0F;
};

std::vector<Between> neighbours(int coarse, int fine)
{
    std::vector<Between> all;
    for (int i = 0; i < fine; ++i) {
        const double place = std::clamp((i + 0.5) * coarse / fine - 0.5, 0.0, coarse - 1.0);
        const int first = static_cast<int>(place);
        all.push_back({first, std::min(first + 1, coarse - 1), static_cast<float>(place - first)});
    }
    return all;
}

/// Rows and columns of `values` numbers per pixel.
void spread(const std::vector<float>& from, int coarseWidth, std::size_t values, const std::vector<Between>& columns,
            const std::vector<Between>& rows, std::vector<float>& to)
{
    float* out = to.data();
    for (const Between& row : rows) {
        const float* upper = &from[values * Image::pixelCount(coarseWidth, row.first)];
        const float* lower = &from[values * Image::pixelCount(coarseWidth, row.second)];
        for (const Between& column : columns)
            for (std::size_t c = 0; c < values; ++c) {
                const std::size_t left = values * static_cast<std::size_t>(column.first) + c;
                const std::size_t right = values * static_cast<std::size_t>(column.second) + c;
                const float above = upper[left] + column.weight * (upper[right] - upper[left]);
                const float below = lower[left] + column.weight * (lower[right] - lower[left]);
                *out++ = above + row.weight * (below - above);
            }
    }
}

} // namespace

Image upscaled(const Image& coarse, int width, int height)
{
    Image image(width, height);
    const auto columns = neighbours(coarse.width, width);
    const auto rows = neighbours(coarse.height, height);
    spread(coarse.rgb, coarse.width, 3, columns, rows, image.rgb);
    if (coarse.coverage.empty())
        image.coverage.clear();
    else
        spread(coarse.coverage, coarse.width, 1, columns, rows, image.coverage);
    return image;
}

} // namespace reflectance
