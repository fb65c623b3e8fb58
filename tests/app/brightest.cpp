// Prints where the brightest hundredth of a picture lies: the mean x and y of its pixels. Serves window_test.py.
#include "core/image/picture_file.h"

#include <algorithm>
#include <iostream>
#include <vector>

int main(int argc, char** argv)
{
    const auto picture = reflectance::readPicture(argc > 1 ? argv[1] : "");
    if (!picture) {
        std::cerr << picture.error().sentence() << '\n';
        return 2;
    }
    const reflectance::Image& image = picture->image;
    std::vector<std::pair<float, std::size_t>> pixels;
    for (std::size_t i = 0; i < image.pixels(); ++i)
        pixels.emplace_back(image.rgb[3 * i] + image.rgb[3 * i + 1] + image.rgb[3 * i + 2], i);
    const std::size_t count = std::max<std::size_t>(1, pixels.size() / 100);
    std::nth_element(pixels.begin(), pixels.begin() + static_cast<std::ptrdiff_t>(count), pixels.end(),
                     std::greater<>());
    const auto width = static_cast<std::size_t>(image.width);
    double x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        x += static_cast<double>(pixels[i].second % width);
        y += static_cast<double>(pixels[i].second / width);
    }
    std::cout << x / static_cast<double>(count) << ' ' << y / static_cast<double>(count) << '\n';
    return 0;
}
