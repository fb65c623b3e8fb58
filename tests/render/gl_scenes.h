// Small scenes for the GL tests, made in code: nothing outside the tree is read.
#pragma once

#include "core/scene/scene.h"

namespace reflectance::test {

/// Two triangles with shared corners: the unit square in z = 0, seen from +z.
[[nodiscard]] std::shared_ptr<const Mesh> square();

/// A sphere seen from the side, under a coloured directional light and a point light, before a plain background.
[[nodiscard]] Scene twoLightScene(const std::string& model, int rings = 48);

/// A picture of 64 x 32 pixels with another colour in each.
[[nodiscard]] std::shared_ptr<const Image> colorfulMap();

/// Sum of the largest channel of what every light can send to the unit sphere.
[[nodiscard]] double brightest(const Scene& scene);

} // namespace reflectance::test
