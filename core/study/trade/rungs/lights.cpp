#include "core/base/text.h"
#include "core/study/trade/bounds.h"
#include "core/study/trade/rungs/rungs.h"

#include <algorithm>

namespace reflectance::rung {

/// Lights are left out faintest first, as long as what they can add together is at most 1 / share of white.
Applied withoutFaintLights(int share, Recipe& recipe)
{
    struct Faint {
        double most;
        std::string name;
        std::size_t index;
    };
    const std::vector<Light> shining = shiningLights(recipe.scene);
    std::vector<Faint> lights;
    for (std::size_t i = 0; i < shining.size(); ++i) {
        const auto I = mostArriving(shining[i]);
        const auto most = I ? largestRadiance(recipe.scene, *I) : std::nullopt;
        if (I && !most)
            return {"no bound is known for " + modelOf(recipe.scene).text.name};
        if (most)
            lights.push_back({*most, shining[i].name, i});
    }
    std::stable_sort(lights.begin(), lights.end(), [](const Faint& a, const Faint& b) { return a.most < b.most; });
    double left = 0.0;
    std::vector<bool> goes(shining.size(), false);
    for (const Faint& light : lights) {
        if (left + light.most > 1.0 / share)
            break;
        left += light.most;
        goes[light.index] = true;
    }
    if (std::none_of(goes.begin(), goes.end(), [](bool g) { return g; }))
        return {"every light may add more than 1/" + std::to_string(share) + " of white"};
    // shiningLights keeps the order of the lights that are on.
    std::size_t index = 0;
    for (Light& light : recipe.scene.lights)
        if (light.on && goes[index++])
            light.on = false;
    Applied applied;
    applied.bound = left;
    return applied;
}

} // namespace reflectance::rung
