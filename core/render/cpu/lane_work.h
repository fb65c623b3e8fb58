// What is computed of many rays at a time, in double, in the widest lanes of this processor. To the same bit as one by one,
// and on every processor: products and sums are never fused.
#pragma once

#include "core/geometry/mesh.h"
#include "core/render/cpu/pixel_rays.h"

namespace reflectance {

/// Rays in floats, as Embree reads them: numbers of all rays side by side.
struct RayColumns {
    float *originX, *originY, *originZ;
    float *directionX, *directionY, *directionZ;
    int* valid; ///< -1: to be traced; 0: not
};

/// Samples and the triangles they met.
struct MetColumns {
    std::size_t count = 0;
    const double *x, *y; ///< image points, in pixels
    const std::uint32_t* triangle;
};

struct PointColumns {
    double *Px, *Py, *Pz, *Nx, *Ny, *Nz;
};

struct LaneWork {
    /// Rays through four columns and `rows` (at most four) rows of image points. They start where they enter a sphere about
    /// the origin, found in double: floats are then as fine as the mesh, however far away the eye is. Rays that miss the
    /// sphere are not to be traced; false, and only `valid` written, if all do.
    bool (*aim)(const PixelRays::Frame& frame, double radius, const double* xs, const double* ys, int rows,
                const RayColumns& rays);
    /// surfacePoint of each sample, along its own ray.
    void (*find)(const Mesh& mesh, const PixelRays::Frame& frame, const MetColumns& met, const PointColumns& points);
};

[[nodiscard]] const LaneWork& laneWorkSse2();
[[nodiscard]] const LaneWork& laneWorkAvx2(); ///< call only where the processor has AVX2
/// The widest that this processor runs.
[[nodiscard]] const LaneWork& laneWork();

} // namespace reflectance
