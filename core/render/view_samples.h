// A view's surface samples: visibility computed once, shaded many times.
#pragma once

#include "core/math/vec.h"
#include "core/render/settings.h"

#include <cstdint>
#include <vector>

namespace reflectance {

/// Only samples that met the object are kept, ordered by pixel. Shading needs P and N; V comes from the eye.
struct ViewSamples {
    RenderSettings settings;
    Vec3d eye;
    std::vector<std::uint32_t> firstOfPixel; ///< width * height + 1 offsets into the arrays below
    std::vector<double> Px, Py, Pz;          ///< position, mesh units
    std::vector<double> Nx, Ny, Nz;          ///< unit shading normal, turned towards the viewer's side of the surface
    std::vector<std::uint32_t> triangle;

    [[nodiscard]] std::size_t count() const { return triangle.size(); }
};

} // namespace reflectance
