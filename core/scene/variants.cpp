#include "core/scene/variants.h"

#include "core/base/text.h"
#include "core/scene/names.h"

#include <vector>

namespace reflectance {

Result<std::size_t> findVariant(const Scene& scene, const std::string& name)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene.variants.size(); ++i) {
        if (scene.variants[i].name == name)
            return i;
        names.push_back(scene.variants[i].name);
    }
    if (names.empty())
        return Error{"the scene keeps no variant '" + name + "'; scene files hold them under 'variants'"};
    return Error{"the scene keeps no variant '" + name + "'; did you mean '" + nearestName(name, names) + "'?"};
}

std::size_t keepVariant(Scene& scene, const Surface& surface)
{
    scene.variants.push_back({freshName(scene.variants, modelOf(surface).text.name), surface});
    return scene.variants.size() - 1;
}

Result<void> renameVariant(Scene& scene, std::size_t index, const std::string& name)
{
    return rename(scene.variants, scene.variants[index].name, name, "variant");
}

} // namespace reflectance
