// Observations from the pixels of a picture whose mesh, camera and lights are known: a render, or a photograph of an object of
// known shape under known light.
#pragma once

#include "core/base/result.h"
#include "core/image/picture_file.h"
#include "core/render/progress.h"
#include "core/scene/scene.h"
#include "core/study/fit/observations.h"

#include <span>

namespace reflectance {

struct PixelPlace {
    int x = 0, y = 0; ///< column and row from the upper left

    friend bool operator==(const PixelPlace&, const PixelPlace&) = default;
};

/// The pixels of `wanted`, or where it is empty all of them (of more than `most` every k-th), that see the object whole and lit:
/// silhouettes, unlit pixels and, in a PNG, clipped ones are left out. A PNG is taken to have gone through the scene's sensor.
/// Refused: no such pixel, a wanted pixel outside the picture or beside the object.
[[nodiscard]] Result<Observations> observationsOf(const Picture& picture, const Scene& scene,
                                                  std::span<const PixelPlace> wanted = {}, std::size_t most = 20000,
                                                  Progress* progress = nullptr);

} // namespace reflectance
