// Pictures that the tests of this folder share.
#pragma once

#include "core/image/image.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace reflectance::test {

/// The bits of every value: equality that tells -0 from 0 and compares NaN with NaN.
inline std::vector<std::uint32_t> bitsOf(const std::vector<float>& values)
{
    std::vector<std::uint32_t> bits;
    for (const float value : values)
        bits.push_back(std::bit_cast<std::uint32_t>(value));
    return bits;
}

/// Every kind of float, each pixel different, so that no swap of rows, columns or channels goes unseen.
inline Image oddImage(int width, int height)
{
    using limits = std::numeric_limits<float>;
    const std::vector<float> odd{0.0F,
                                 -0.0F,
                                 limits::denorm_min(),
                                 limits::min(),
                                 limits::max(),
                                 -limits::max(),
                                 limits::infinity(),
                                 -limits::infinity(),
                                 limits::quiet_NaN(),
                                 1.0F / 3.0F};
    Image image(width, height);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = i < odd.size() ? odd[i] : static_cast<float>(i) * 0.37F - 5.0F;
    for (std::size_t i = 0; i < image.coverage.size(); ++i)
        image.coverage[i] = static_cast<float>(i) / static_cast<float>(image.coverage.size());
    return image;
}

inline Image flipped(const Image& image)
{
    Image result = image;
    for (int y = 0; y < image.height; ++y)
        for (int i = 0; i < 3 * image.width; ++i)
            result.at(0, y)[i] = image.at(0, image.height - 1 - y)[i];
    return result;
}

} // namespace reflectance::test
