#include "core/render/cpu/background.h"

#include <algorithm>

namespace reflectance {
namespace {

/// Bit s tells whether sample s of pixel (x, y) is among samples first .. last.
std::uint64_t coveredMask(const ViewSamples& samples, const Camera& camera, std::size_t first, std::size_t last, int x,
                          int y)
{
    const auto& [width, height, k] = samples.settings;
    const auto cell = [k = k](double offset) { return std::clamp(static_cast<int>(offset * k), 0, k - 1); };
    std::uint64_t mask = 0;
    for (std::size_t i = first; i < last; ++i) {
        const Vec3d seen = projected(camera, {samples.Px[i], samples.Py[i], samples.Pz[i]}, width, height);
        mask |= std::uint64_t{1} << (cell(seen.y - y) * k + cell(seen.x - x));
    }
    return mask;
}

} // namespace

BackgroundSampler::BackgroundSampler(const Scene& scene, const RenderSettings& settings)
    : perPixel_(settings.samplesPerAxis * settings.samplesPerAxis),
      plain_(scene.background.kind == BackgroundKind::Plain), scene_(scene), settings_(settings),
      rays_(scene.camera, settings)
{
}

Vec3d BackgroundSampler::environmentSum(const ViewSamples& samples, std::size_t first, std::size_t last,
                                        std::size_t pixel) const
{
    const int x = static_cast<int>(pixel % static_cast<std::size_t>(settings_.width));
    const int y = static_cast<int>(pixel / static_cast<std::size_t>(settings_.width));
    const std::uint64_t covered = coveredMask(samples, scene_.camera, first, last, x, y);
    Vec3d total;
    for (int s = 0; s < perPixel_; ++s)
        if ((covered >> s & 1U) == 0)
            total += radianceFrom(scene_.environment, rays_.throughSample(x, y, s));
    return total;
}

} // namespace reflectance
