// The CPU renderer, three functions from values to values: a mesh to a ray scene (Embree), a camera to surface samples,
// samples to a picture. In double it is the truth of this program.
#pragma once

#include "core/image/image.h"
#include "core/reflectance/arithmetic.h"
#include "core/reflectance/observation.h"
#include "core/render/progress.h"
#include "core/render/settings.h"
#include "core/render/view_samples.h"
#include "core/scene/scene.h"

#include <memory>
#include <span>

namespace reflectance {

/// What Embree keeps for a mesh. It only says which triangle a ray meets; position, barycentrics and normal are
/// recomputed in double from the mesh (Embree's float u and v cost 1e-4 in the normal).
class RayScene;
[[nodiscard]] std::shared_ptr<const RayScene> makeRayScene(std::shared_ptr<const Mesh> mesh);
/// For one view of these settings: sooner made where many triangles meet few samples. The samples are the same.
[[nodiscard]] std::shared_ptr<const RayScene> makeRayScene(std::shared_ptr<const Mesh> mesh,
                                                           const RenderSettings& once);

[[nodiscard]] ViewSamples sampleView(const RayScene& rays, const Camera& camera, const RenderSettings& settings,
                                     Progress* progress = nullptr);

/// Shades the samples in double, float or SIMD (not Glsl); pixels without a sample show the background.
[[nodiscard]] Image shadeSamples(const ViewSamples& samples, const Scene& scene, const Arithmetic& arithmetic,
                                 Progress* progress = nullptr);

/// Samples and shading at once, tile by tile: the same picture, and no samples to keep. They are `share` of what the
/// progress counts. The ray scene is that of the scene's mesh.
[[nodiscard]] Image renderOnCpu(const RayScene& rays, const Scene& scene, const RenderSettings& settings,
                                const Arithmetic& arithmetic, Progress* progress = nullptr, double share = 1.0);

/// All three.
[[nodiscard]] Image renderOnCpu(const Scene& scene, const RenderSettings& settings, const Arithmetic& arithmetic,
                                Progress* progress = nullptr, double share = 1.0);

} // namespace reflectance
