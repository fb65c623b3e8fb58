#include "core/render/gl/sample_reader.h"

#include <algorithm>

namespace reflectance {
namespace {

/// Four floats of a texel, column x of row y.
const float* texel(const std::vector<float>& rows, int width, int x, int y)
{
    return &rows[4 * Image::pixelCount(width, y) + 4 * static_cast<std::size_t>(x)];
}

void append(ViewSamples& samples, const float* normal, const float* position, std::uint32_t triangle)
{
    samples.Nx.push_back(normal[0]);
    samples.Ny.push_back(normal[1]);
    samples.Nz.push_back(normal[2]);
    samples.Px.push_back(position[0]);
    samples.Py.push_back(position[1]);
    samples.Pz.push_back(position[2]);
    samples.triangle.push_back(triangle);
}

} // namespace

void SampleReader::readRows(const RenderTarget& target, int texture, int firstRow, int rows, std::vector<float>& into)
{
    const std::size_t floats = 4 * Image::pixelCount(target.width(), rows);
    if (into.size() < floats)
        into.resize(floats);
    target.bindForReading(texture);
    gl_->ReadPixels(0, firstRow, target.width(), rows, GL_RGBA, GL_FLOAT, into.data());
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

void SampleReader::readTriangles(const RenderTarget& target, int firstRow, int rows)
{
    triangles_.resize(Image::pixelCount(target.width(), rows));
    target.bindForReading(0);
    gl_->ReadPixels(0, firstRow, target.width(), rows, GL_RED_INTEGER, GL_UNSIGNED_INT, triangles_.data());
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

Image SampleReader::readImage(const RenderTarget& linear)
{
    Image image(linear.width(), linear.height());
    constexpr int rowsAtATime = 32; // stay in the cache, and are no second picture in memory
    for (int first = 0; first < image.height; first += rowsAtATime) {
        const int rows = std::min(rowsAtATime, image.height - first);
        readRows(linear, 0, first, rows, first_);
        for (int row = 0; row < rows; ++row) {
            std::size_t pixel = Image::pixelCount(image.width, image.height - 1 - (first + row));
            for (int x = 0; x < image.width; ++x, ++pixel) {
                const float* from = texel(first_, image.width, x, row);
                std::copy_n(from, 3, &image.rgb[3 * pixel]);
                image.coverage[pixel] = from[3];
            }
        }
    }
    return image;
}

ViewSamples SampleReader::readSamples(const RenderTarget& triangles, const RenderTarget& surface,
                                      const RenderSettings& settings, const Vec3d& eye)
{
    ViewSamples samples;
    samples.settings = settings;
    samples.eye = eye;
    samples.firstOfPixel.reserve(Image::pixelCount(settings.width, settings.height) + 1);
    const int k = settings.samplesPerAxis;
    const int across = surface.width();
    for (int row = settings.height - 1; row >= 0; --row) { // one row of pixels at a time: k rows of samples
        readTriangles(triangles, row * k, k);
        readRows(surface, 0, row * k, k, first_);
        readRows(surface, 1, row * k, k, second_);
        for (int x = 0; x < settings.width; ++x) {
            samples.firstOfPixel.push_back(static_cast<std::uint32_t>(samples.count()));
            for (int j = k - 1; j >= 0; --j)
                for (int i = x * k; i < (x + 1) * k; ++i)
                    if (const auto hit = triangles_[Image::pixelCount(across, j) + static_cast<std::size_t>(i)];
                        hit != 0)
                        append(samples, texel(first_, across, i, j), texel(second_, across, i, j), hit - 1);
        }
    }
    samples.firstOfPixel.push_back(static_cast<std::uint32_t>(samples.count()));
    return samples;
}

} // namespace reflectance
