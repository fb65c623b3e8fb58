#include "core/study/sweep/kept_meshes.h"

#include "core/scene/scene_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace reflectance {

Result<Scene> KeptMeshes::scene(const std::string& json, const std::string& folder)
{
    auto keys = nlohmann::ordered_json::parse(json);
    std::string name;
    for (const char* key : {"mesh", "smooth_normals"})
        if (const auto found = keys.find(key); found != keys.end()) {
            name += std::string(key) + found->dump();
            keys.erase(key);
        }
    const auto known = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.name == name; });
    if (known == kept_.end()) {
        auto scene = parseScene(json, "", folder);
        if (scene)
            keep({name, scene->meshFile, scene->mesh, nullptr, scene->recomputeNormals});
        return scene;
    }
    kept_.splice(kept_.begin(), kept_, known);
    auto scene = parseScene(keys.dump(), "", folder);
    if (!scene)
        return scene;
    scene->mesh = known->mesh;
    scene->meshFile = known->file;
    scene->recomputeNormals = known->recomputeNormals;
    return scene;
}

std::shared_ptr<const RayScene> KeptMeshes::rays(const Scene& scene)
{
    for (Kept& kept : kept_)
        if (kept.mesh == scene.mesh) {
            if (!kept.rays)
                kept.rays = makeRayScene(kept.mesh);
            return kept.rays;
        }
    return makeRayScene(scene.mesh);
}

void KeptMeshes::keep(Kept kept)
{
    kept_.push_front(std::move(kept));
    std::size_t triangles = 0;
    auto first = kept_.begin();
    for (; first != kept_.end(); ++first) {
        triangles += first->mesh->triangles.size();
        if (triangles > mostTriangles && first != kept_.begin())
            break;
    }
    kept_.erase(first, kept_.end());
}

} // namespace reflectance
