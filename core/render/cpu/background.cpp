#include "core/render/cpu/background.h"

#include <algorithm>

namespace reflectance {

BackgroundSampler::BackgroundSampler(const Scene& scene, const RenderSettings& settings)
    : scene_(scene), settings_(settings), rays_(scene.camera, settings)
{
}

Vec3d BackgroundSampler::sum(const ViewSamples& samples, std::size_t first, std::size_t last, int x, int y) const
{
    const int perPixel = settings_.samplesPerAxis * settings_.samplesPerAxis;
    const int uncovered = perPixel - static_cast<int>(last - first);
    if (uncovered == 0)
        return {};
    if (scene_.background.kind == BackgroundKind::Plain)
        return static_cast<double>(uncovered) * scene_.background.color;
    const std::uint64_t covered = coveredMask(samples, first, last, x, y);
    Vec3d total;
    for (int s = 0; s < perPixel; ++s)
        if ((covered >> s & 1U) == 0)
            total += radianceFrom(scene_.environment, rays_.throughSample(x, y, s));
    return total;
}

std::uint64_t BackgroundSampler::coveredMask(const ViewSamples& samples, std::size_t first, std::size_t last, int x,
                                             int y) const
{
    const int k = settings_.samplesPerAxis;
    const auto cell = [k](double offset) { return std::clamp(static_cast<int>(offset * k), 0, k - 1); };
    std::uint64_t mask = 0;
    for (std::size_t i = first; i < last; ++i) {
        const Vec3d seen = projected(scene_.camera, {samples.Px[i], samples.Py[i], samples.Pz[i]}, settings_.width,
                                     settings_.height);
        mask |= std::uint64_t{1} << (cell(seen.y - y) * k + cell(seen.x - x));
    }
    return mask;
}

} // namespace reflectance
