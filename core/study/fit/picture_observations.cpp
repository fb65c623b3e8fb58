#include "core/study/fit/picture_observations.h"

#include "core/math/angle.h"
#include "core/render/cpu/cpu_renderer.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace reflectance {
namespace {

/// Neighbouring pixels whose normals are farther apart than 10 degrees do not lie on one smooth surface.
const double leastAgreement = std::cos(radians(10.0));

class PixelReader {
public:
    PixelReader(const Picture& picture, const Scene& scene, Progress* progress)
        : picture_(picture), lights_(shiningLights(scene)),
          perCode_(picture.isLinear() ? 1.0 : 1.0 / gainOf(scene.sensor)),
          samples_(sampleView(*makeRayScene(scene.mesh), scene.camera, {picture.image.width, picture.image.height, 1},
                              progress))
    {
    }

    [[nodiscard]] bool meetsObject(int x, int y) const { return sampleOf(x, y).has_value(); }

    /// Adds the pixel, if it sees the object whole and lit and the sensor could show it.
    void take(int x, int y, Observations& observations) const
    {
        if (!seesWhole(x, y) || isClipped(x, y))
            return;
        const std::size_t i = *sampleOf(x, y);
        const Vec3d P{samples_.Px[i], samples_.Py[i], samples_.Pz[i]};
        Observation row{normalOf(i), normalized(samples_.eye - P), {}};
        for (const Light& light : lights_)
            if (const Arrival arrival = arrivalAt(light, P); dot(row.N, arrival.L) > 0.0)
                row.lights.push_back({arrival.L, arrival.I, light.angularRadius});
        if (row.lights.empty())
            return;
        const float* const rgb = picture_.image.at(x, y);
        observations.rows.push_back(std::move(row));
        observations.seen.push_back(Vec3d{rgb[0], rgb[1], rgb[2]} * perCode_);
        observations.cosine.push_back(1.0);
    }

private:
    [[nodiscard]] std::optional<std::size_t> sampleOf(int x, int y) const
    {
        if (x < 0 || y < 0 || x >= picture_.image.width || y >= picture_.image.height)
            return std::nullopt;
        const std::size_t pixel = Image::pixelCount(picture_.image.width, y) + static_cast<std::size_t>(x);
        const std::size_t first = samples_.firstOfPixel[pixel];
        return first < samples_.firstOfPixel[pixel + 1] ? std::optional(first) : std::nullopt;
    }

    /// A pixel is a mean over its area: next to one that misses the object it may hold background, and across an edge two
    /// surfaces that one normal cannot stand for.
    [[nodiscard]] bool seesWhole(int x, int y) const
    {
        const auto middle = sampleOf(x, y);
        if (!middle)
            return false;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (const auto i = sampleOf(x + dx, y + dy);
                    !i || dot(normalOf(*i), normalOf(*middle)) < leastAgreement)
                    return false;
        return true;
    }

    [[nodiscard]] Vec3d normalOf(std::size_t i) const { return {samples_.Nx[i], samples_.Ny[i], samples_.Nz[i]}; }

    [[nodiscard]] bool isClipped(int x, int y) const
    {
        const float* const rgb = picture_.image.at(x, y);
        return !picture_.isLinear() && std::any_of(rgb, rgb + 3, [](float v) { return !(v > 0.0F && v < 1.0F); });
    }

    const Picture& picture_;
    std::vector<Light> lights_;
    double perCode_;
    ViewSamples samples_;
};

Result<void> checkedPixels(const Picture& picture, const PixelReader& reader, std::span<const PixelPlace> wanted)
{
    for (const auto [x, y] : wanted) {
        const std::string name = "pixel " + std::to_string(x) + "," + std::to_string(y);
        if (x < 0 || y < 0 || x >= picture.image.width || y >= picture.image.height)
            return Error{name + " lies outside the picture of " + std::to_string(picture.image.width) + " x " +
                         std::to_string(picture.image.height) + " pixels"};
        if (!reader.meetsObject(x, y))
            return Error{name + " does not show the object; choose one that does"};
    }
    return {};
}

} // namespace

Result<Observations> observationsOf(const Picture& picture, const Scene& scene, std::span<const PixelPlace> wanted,
                                    std::size_t most, Progress* progress)
{
    const PixelReader reader(picture, scene, progress);
    if (const auto valid = checkedPixels(picture, reader, wanted); !valid)
        return valid.error();
    Observations observations{"the picture", ObservedForm::Color, {}, {}, {}};
    for (const auto [x, y] : wanted)
        reader.take(x, y, observations);
    const std::size_t step = wanted.empty() ? picture.image.pixels() / most + 1 : picture.image.pixels();
    const auto width = static_cast<std::size_t>(picture.image.width);
    for (std::size_t pixel = 0; wanted.empty() && pixel < picture.image.pixels(); pixel += step)
        reader.take(static_cast<int>(pixel % width), static_cast<int>(pixel / width), observations);
    if (observations.rows.empty())
        return Error{"no pixel shows the object whole, lit and unclipped; check that the scene is the picture's own"};
    return observations;
}

} // namespace reflectance
