// Scenes of cells, whose meshes are read once and kept: most studies have one mesh, or a few that come again and again.
#pragma once

#include "core/render/cpu/cpu_renderer.h"

#include <cstddef>
#include <list>
#include <memory>
#include <string>

namespace reflectance {

class KeptMeshes {
public:
    /// So many triangles are kept, or the last mesh alone where it has more.
    static constexpr std::size_t mostTriangles = 8'000'000;

    /// parseScene, but for the mesh, which is read when it is met for the first time.
    [[nodiscard]] Result<Scene> scene(const std::string& json, const std::string& folder);
    /// Of a scene that came from here: Embree's structure, made once.
    [[nodiscard]] std::shared_ptr<const RayScene> rays(const Scene& scene);
    [[nodiscard]] std::size_t size() const { return kept_.size(); }

private:
    struct Kept {
        std::string name; ///< what the scene says of the mesh
        std::string file;
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const RayScene> rays = nullptr;
        bool recomputeNormals = false;
    };
    void keep(Kept kept);

    std::list<Kept> kept_; ///< last used first
};

} // namespace reflectance
