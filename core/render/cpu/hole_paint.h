// Stripes on the object where a measured table was not measured, as the GL renderer paints them.
#pragma once

#include "core/reflectance/shade_block.h"
#include "core/render/view_samples.h"
#include "core/scene/scene.h"

namespace reflectance {

/// Whether the scene wants its table's holes to be seen.
[[nodiscard]] bool showsHoles(const Scene& scene);

/// Paints those of the samples first .. first + count that a light which is on meets in a hole. Decided in double in every
/// precision, so that all pictures agree on what is a hole.
template <class T>
void paintHoles(const ViewSamples& samples, const Scene& scene, std::size_t first, std::size_t count,
                Vec3Column<T>& sum);

extern template void paintHoles(const ViewSamples&, const Scene&, std::size_t, std::size_t, Vec3Column<double>&);
extern template void paintHoles(const ViewSamples&, const Scene&, std::size_t, std::size_t, Vec3Column<float>&);

} // namespace reflectance
