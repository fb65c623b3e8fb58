// A finely tessellated unit sphere and the scenes that the renderer's tests look at.
#pragma once

#include "core/scene/scene.h"

#include <memory>

namespace reflectance::test {

/// Unit sphere of rings x 2 rings quads, its normals exactly radial.
[[nodiscard]] std::shared_ptr<const Mesh> sphereMesh(int rings);

/// The sphere seen from +z, lit from the upper right; one directional light, black background.
[[nodiscard]] Scene sphereScene(const std::string& model, int rings = 64);

} // namespace reflectance::test
