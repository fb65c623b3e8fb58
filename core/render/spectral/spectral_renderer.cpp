#include "core/render/spectral/spectral_renderer.h"

#include "core/base/check.h"
#include "core/math/quantile.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reflectance {
namespace {

/// The wavelengths k, k + 1, k + 2; beyond the grid 0.
Vec3d threeOf(const std::vector<double>& values, std::size_t k)
{
    const auto at = [&values](std::size_t i) { return i < values.size() ? values[i] : 0.0; };
    return {at(k), at(k + 1), at(k + 2)};
}

void setK(Scene& scene, const Mat3d& K)
{
    const auto numbers = rowByRow(K);
    scene.surface.values["K"] = {numbers.begin(), numbers.end()};
}

/// Nothing but the lights: no surroundings, a black background.
Scene lightsAlone(const Scene& scene)
{
    Scene alone = scene;
    alone.environment = Environment();
    alone.environment.kind = EnvironmentKind::None;
    alone.background = {BackgroundKind::Plain, Vec3d()};
    return alone;
}

/// What is there without any light: background and surroundings.
std::vector<double> withoutLights(const ViewSamples& samples, const Scene& scene, Image& image)
{
    Scene dark = scene;
    dark.lights.clear();
    image = shadeSamples(samples, dark, Precision::Double);
    return {image.rgb.begin(), image.rgb.end()};
}

void addWavelengths(std::vector<double>& sums, const Image& picture, const ColorSystem& system, std::size_t k)
{
    const Mat3d sees{{threeOf(system.sensors[0], k), threeOf(system.sensors[1], k), threeOf(system.sensors[2], k)}};
    for (std::size_t i = 0; i < sums.size(); i += 3) {
        const Vec3d seen = sees * Vec3d(picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]);
        sums[i] += seen.x;
        sums[i + 1] += seen.y;
        sums[i + 2] += seen.z;
    }
}

Vec3d pixelOf(const Image& image, std::size_t pixel)
{
    const float* rgb = &image.rgb[3 * pixel];
    return {rgb[0], rgb[1], rgb[2]};
}

PicturePrice priceOf(const Image& truth, const Image& cheat, const Mat3d& toXyz, const Vec3d& white)
{
    PicturePrice price;
    std::vector<double> errors;
    for (std::size_t pixel = 0; pixel < truth.pixels(); ++pixel) {
        if (truth.coverage[pixel] < 1.0F)
            continue;
        const ColorError error = colorError(toXyz, pixelOf(truth, pixel), pixelOf(cheat, pixel), white);
        errors.push_back(error.deltaE);
        price.maxLinear = std::max(price.maxLinear, error.linear);
        price.negative += error.negative;
    }
    if (errors.empty())
        return price;
    price.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    price.max = *std::max_element(errors.begin(), errors.end());
    price.p95 = quantileOf(std::move(errors), 0.95);
    return price;
}

} // namespace

Result<SpectralScene> spectralScene(const Scene& scene, const ColorSystem& system, const JudgedSurface& surface,
                                    const JudgedLight* spectrum)
{
    const Parameter* K = modelOf(scene).text.find("K");
    if (K == nullptr || K->kind != ParameterKind::Matrix)
        return Error{"the model '" + scene.surface.model +
                     "' has no matrix K for a spectrum to take the place of; use lambert_color or hybrid"};
    SpectralScene spectral{scene, surface.S, {}};
    spectral.scene.surface.convention = Convention::Sensor; // spectra replace K and the numbers of the lights
    for (const Light& light : scene.lights) {
        const Vec3d I = light.intensity;
        const double brightness = std::max({I.x, I.y, I.z});
        std::vector<double> power(system.grid.size());
        for (std::size_t k = 0; k < power.size(); ++k)
            power[k] = spectrum ? brightness * spectrum->power[k]
                                : dot(I, {system.primaries[0][k], system.primaries[1][k], system.primaries[2][k]});
        spectral.power.push_back(std::move(power));
    }
    return spectral;
}

Image shadeSpectral(const ViewSamples& samples, const SpectralScene& spectral, const ColorSystem& system,
                    Progress* progress)
{
    CHECK_EQ(spectral.power.size(), spectral.scene.lights.size());
    Image image;
    std::vector<double> sums = withoutLights(samples, spectral.scene, image);
    Scene scene = lightsAlone(spectral.scene);
    for (std::size_t k = 0; k < system.grid.size() && !(progress && progress->cancel); k += 3) {
        setK(scene, diagonalMatrix(threeOf(spectral.S, k)));
        for (std::size_t l = 0; l < scene.lights.size(); ++l)
            scene.lights[l].intensity = threeOf(spectral.power[l], k);
        addWavelengths(sums, shadeSamples(samples, scene, Precision::Double), system, k);
        if (progress)
            progress->done = static_cast<double>(k) / static_cast<double>(system.grid.size());
    }
    std::transform(sums.begin(), sums.end(), image.rgb.begin(), [](double sum) { return static_cast<float>(sum); });
    return image;
}

Scene cheatScene(const SpectralScene& spectral, const ColorSystem& system, const Mat3d& matrix)
{
    Scene scene = spectral.scene;
    setK(scene, matrix);
    for (std::size_t l = 0; l < scene.lights.size(); ++l)
        scene.lights[l].intensity = system.response(spectral.power[l], {});
    return scene;
}

std::vector<PicturePrice> pricesOnPicture(const ViewSamples& samples, const SpectralScene& spectral,
                                          const ColorSystem& system, const JudgedSurface& surface, const Vec3d& white,
                                          Progress* progress)
{
    const Image truth = shadeSpectral(samples, spectral, system, progress);
    const Mat3d toXyz = xyzFromSensor(system);
    std::vector<PicturePrice> prices;
    for (const Cheat cheat : allCheats) {
        const Scene scene = cheatScene(spectral, system, matrixBy(cheat, system, surface));
        prices.push_back(priceOf(truth, shadeSamples(samples, scene, Precision::Double), toXyz, white));
        prices.back().cheat = cheat;
    }
    return prices;
}

} // namespace reflectance
