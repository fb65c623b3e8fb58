#include "core/study/plots/balls.h"

#include "core/math/angle.h"
#include "core/reflectance/shade_block.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reflectance {
namespace {

constexpr float ground = 0.028F; ///< radiance beside a ball
constexpr double discForMirrors = 5.0;
constexpr int samplesPerAxis = 2;

/// The samples of one row of pixels that meet the ball, with the pixel of each.
struct Row {
    std::vector<Vec3d> N;
    std::vector<int> pixel;
};

Row rowOf(int y, int size)
{
    Row row;
    for (int x = 0; x < size; ++x)
        for (int k = 0; k < samplesPerAxis * samplesPerAxis; ++k) {
            const auto place = [size](int at, int sub) {
                return 2.0 * (at + (sub + 0.5) / samplesPerAxis) / size - 1.0;
            };
            if (const auto N = normalAt(place(x, k % samplesPerAxis), -place(y, k / samplesPerAxis))) {
                row.N.push_back(*N);
                row.pixel.push_back(x);
            }
        }
    return row;
}

void shadeRow(const NamedSurface& surface, const BallLight& light, const Row& row, std::vector<Vec3f>& sums)
{
    ShadeBlock<float> block;
    const bool seesExtent = surface.model->text.usesLightSize;
    block.L.fill(normalized(light.L));
    block.V.fill({0, 0, 1});
    block.I.fill(light.I);
    block.lightDisc.fill(static_cast<float>(squaredChord(seesExtent ? std::max(light.radius, discForMirrors) : 0.0)));
    for (std::size_t begin = 0; begin < row.N.size(); begin += blockSize) {
        const std::size_t count = std::min(blockSize, row.N.size() - begin);
        for (std::size_t i = 0; i < count; ++i)
            block.N.set(i, row.N[begin + i]);
        block.sum.fill({});
        ShadeBatch<float> batch = block.batch(count);
        batch.measured = surface.measured.single;
        surface.model->lanes.shade(surface.values.data(), batch);
        for (std::size_t i = 0; i < count; ++i)
            sums[begin + i] += block.sum[i];
    }
}

/// Pixels are means of their samples; those that miss the ball show the ground.
void fillRow(Image& picture, int y, const Row& row, const std::vector<Vec3f>& sums)
{
    constexpr float share = 1.0F / (samplesPerAxis * samplesPerAxis);
    float* const coverage = &picture.coverage[Image::pixelCount(picture.width, y)];
    for (std::size_t i = 0; i < row.pixel.size(); ++i) {
        float* const rgb = picture.at(row.pixel[i], y);
        rgb[0] += share * sums[i].x;
        rgb[1] += share * sums[i].y;
        rgb[2] += share * sums[i].z;
        coverage[row.pixel[i]] += share;
    }
    for (int x = 0; x < picture.width; ++x)
        for (int channel = 0; channel < 3; ++channel)
            picture.at(x, y)[channel] += ground * (1.0F - coverage[x]);
}

} // namespace

std::optional<Vec3d> normalAt(double x, double y)
{
    constexpr double radius = 0.94; // a rim of ground around it
    const double nx = x / radius, ny = y / radius;
    const double rest = 1.0 - nx * nx - ny * ny;
    if (!(rest > 0.0))
        return std::nullopt;
    return Vec3d{nx, ny, std::sqrt(rest)};
}

std::optional<BallStrip> ballsOf(const std::vector<NamedSurface>& surfaces, const std::vector<BallLight>& lights,
                                 const Sensor& sensor, int size, Progress& progress)
{
    BallStrip strip;
    strip.size = size;
    strip.sensor = sensor;
    for (const NamedSurface& surface : surfaces) {
        Ball ball{surface.name, surface.color, Image(size, size)};
        for (int y = 0; y < size; ++y) {
            if (progress.cancel)
                return std::nullopt;
            const Row row = rowOf(y, size);
            std::vector<Vec3f> sums(row.N.size());
            for (const BallLight& light : lights)
                if (normalized(light.L) != Vec3d())
                    shadeRow(surface, light, row, sums);
            fillRow(ball.picture, y, row, sums);
        }
        strip.balls.push_back(std::move(ball));
        progress.done = static_cast<double>(strip.balls.size()) / static_cast<double>(surfaces.size());
    }
    return strip;
}

} // namespace reflectance
