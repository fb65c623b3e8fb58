// A hazard as something to look at: a scene whose middle pixel is the very case, or the reason why there is no picture.
#pragma once

#include "core/scene/scene.h"
#include "core/study/extremes/bench.h"

#include <functional>
#include <optional>
#include <string>

namespace reflectance {

struct Exhibit {
    std::optional<Scene> scene; ///< none: there is nothing to see
    std::string caption;        ///< where to look and what for; without a scene, why there is none
};

/// Made when somebody wants to see it.
using Show = std::function<Exhibit()>;

[[nodiscard]] Show unseen(std::string why);

/// The model on a sphere: the picture's middle is the point with the normal N, the camera looks along V, the light shines
/// along L. A sharp highlight is shown on a square, from so near that it fills a tenth of the picture.
[[nodiscard]] Show seen(Question question, std::string caption);

/// A mesh file's text under one light, as the reader takes it.
[[nodiscard]] Show seenMesh(std::string objText, std::string caption);

/// A plain scene as the function makes it; where that fails, its error is the reason.
[[nodiscard]] Show seenScene(std::function<Result<Scene>()> make, std::string caption);

/// Nothing but radiance before the sensor: value(x, y) over the picture, x from 0 at the left to 1 at the right, y from 0
/// at the top to 1 at the foot.
[[nodiscard]] Show seenRadiance(std::function<double(double x, double y)> value, std::string caption);

/// A light that fits the mesh, hybrid on black, seen whole. For meshes in the text of an OBJ file.
[[nodiscard]] Result<Scene> sceneOfObj(const std::string& objText);

} // namespace reflectance
