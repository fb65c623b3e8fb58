#include "core/study/lens/thinned.h"

#include <algorithm>
#include <numeric>

namespace reflectance {
namespace {

void append(const ViewSamples& from, std::size_t pixel, ViewSamples& to)
{
    for (std::size_t i = from.firstOfPixel[pixel]; i < from.firstOfPixel[pixel + 1]; ++i) {
        for (std::vector<double> ViewSamples::*column : {&ViewSamples::Px, &ViewSamples::Py, &ViewSamples::Pz,
                                                         &ViewSamples::Nx, &ViewSamples::Ny, &ViewSamples::Nz})
            (to.*column).push_back((from.*column)[i]);
        to.triangle.push_back(from.triangle[i]);
    }
    to.firstOfPixel.push_back(static_cast<std::uint32_t>(to.count()));
}

} // namespace

ViewSamples crossings(const ViewSamples& samples, const std::vector<int>& columns, const std::vector<int>& rows)
{
    ViewSamples few;
    few.settings = {static_cast<int>(columns.size()), static_cast<int>(rows.size()), samples.settings.samplesPerAxis};
    few.eye = samples.eye;
    few.firstOfPixel.push_back(0);
    for (const int y : rows)
        for (const int x : columns)
            append(samples, Image::pixelCount(samples.settings.width, y) + static_cast<std::size_t>(x), few);
    return few;
}

std::vector<int> middles(int size, int stride)
{
    std::vector<int> places;
    for (int place = stride / 2; place < size; place += stride)
        places.push_back(place);
    return places;
}

ViewSamples everyNth(const ViewSamples& samples, int stride)
{
    return crossings(samples, middles(samples.settings.width, stride), middles(samples.settings.height, stride));
}

Image everyNth(const Image& image, int stride)
{
    const std::vector<int> columns = middles(image.width, stride);
    const std::vector<int> rows = middles(image.height, stride);
    Image few(static_cast<int>(columns.size()), static_cast<int>(rows.size()));
    for (int y = 0; y < few.height; ++y)
        for (int x = 0; x < few.width; ++x) {
            const int fromX = columns[static_cast<std::size_t>(x)];
            const int fromY = rows[static_cast<std::size_t>(y)];
            std::copy_n(image.at(fromX, fromY), 3, few.at(x, y));
            const std::size_t from = Image::pixelCount(image.width, fromY) + static_cast<std::size_t>(fromX);
            if (!image.coverage.empty())
                few.coverage[Image::pixelCount(few.width, y) + static_cast<std::size_t>(x)] = image.coverage[from];
        }
    return few;
}

ViewSamples eachAPixel(ViewSamples samples)
{
    samples.settings = {static_cast<int>(samples.count()), 1, 1};
    samples.firstOfPixel.resize(samples.count() + 1);
    std::iota(samples.firstOfPixel.begin(), samples.firstOfPixel.end(), 0U);
    return samples;
}

} // namespace reflectance
