#include "app/explorer/object_price.h"

#include "core/study/lens/thinned.h"

#include <cmath>

namespace reflectance::explorer {
namespace {

constexpr double mostPixels = 20'000;

ViewSamples thinned(const ViewSamples& samples)
{
    const auto pixels = static_cast<double>(samples.firstOfPixel.size());
    const int stride = static_cast<int>(std::ceil(std::sqrt(pixels / mostPixels)));
    return stride > 1 ? everyNth(samples, stride) : samples;
}

} // namespace

std::optional<ObjectPrices> objectPrices(const ObjectQuestion& question, Progress& progress)
{
    const JudgedLight& light = question.light;
    ObjectPrices found{question.surface.name, light.inSpan ? "the scene's lights" : light.name, {}, {}};
    const auto spectral =
        spectralScene(question.scene, question.system, question.surface, light.inSpan ? nullptr : &light);
    if (!spectral) {
        found.problem = spectral.error().message;
        return found;
    }
    found.prices = pricesOnPicture(thinned(question.samples), *spectral, question.system, question.surface,
                                   light.inSpan ? question.system.W * Vec3d(1.0) : light.white, &progress);
    return progress.cancel ? std::nullopt : std::optional(found);
}

} // namespace reflectance::explorer
