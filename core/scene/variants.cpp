#include "core/scene/variants.h"

#include "core/base/text.h"

#include <algorithm>
#include <vector>

namespace reflectance {
namespace {

bool isTaken(const Scene& scene, const std::string& name)
{
    return std::any_of(scene.variants.begin(), scene.variants.end(),
                       [&](const KeptSurface& variant) { return variant.name == name; });
}

} // namespace

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

std::string freshVariantName(const Scene& scene, const std::string& stem)
{
    std::string name = stem;
    for (int n = 2; isTaken(scene, name); ++n)
        name = stem + " " + std::to_string(n);
    return name;
}

std::size_t keepVariant(Scene& scene, const Surface& surface)
{
    scene.variants.push_back({freshVariantName(scene, modelOf(surface).text.name), surface});
    return scene.variants.size() - 1;
}

Result<void> renameVariant(Scene& scene, std::size_t index, const std::string& name)
{
    std::string& current = scene.variants[index].name;
    if (name == current)
        return {};
    if (trimmed(name).empty())
        return Error{"a variant needs a name; type one"};
    if (isTaken(scene, name))
        return Error{"another variant is named '" + name + "'; choose another name"};
    current = name;
    return {};
}

} // namespace reflectance
