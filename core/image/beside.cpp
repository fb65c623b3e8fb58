#include "core/image/beside.h"

#include "core/base/check.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

/// Copies `count` pixels of a row, and their coverage where both pictures have some.
void copyPixels(const Image& from, int x, int y, int count, Image& to, int toX)
{
    std::copy_n(from.at(x, y), 3 * static_cast<std::ptrdiff_t>(count), to.at(toX, y));
    if (from.coverage.empty() || to.coverage.empty())
        return;
    const auto offset = [y](const Image& image, int column) {
        return static_cast<std::ptrdiff_t>(Image::pixelCount(image.width, y)) + column;
    };
    std::copy_n(from.coverage.begin() + offset(from, x), count, to.coverage.begin() + offset(to, toX));
}

void checkSizes(const Image& a, const Image& b)
{
    CHECK_EQ(a.width, b.width);
    CHECK_EQ(a.height, b.height);
}

} // namespace

Image sideBySide(const Image& a, const Image& b, int gap)
{
    checkSizes(a, b);
    Image both(2 * a.width + gap, a.height);
    for (int y = 0; y < a.height; ++y) {
        copyPixels(a, 0, y, a.width, both, 0);
        copyPixels(b, 0, y, b.width, both, a.width + gap);
    }
    return both;
}

Image wiped(const Image& a, const Image& b, double divider)
{
    checkSizes(a, b);
    const int columns = std::clamp(static_cast<int>(std::lround(divider * a.width)), 0, a.width);
    Image both = b;
    for (int y = 0; y < a.height; ++y)
        copyPixels(a, 0, y, columns, both, 0);
    return both;
}

} // namespace reflectance
