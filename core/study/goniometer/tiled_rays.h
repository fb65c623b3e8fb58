// Rays over a patch that repeats without end: one that leaves a side of the period goes on at the opposite side.
#pragma once

#include "core/render/cpu/ray_scene.h"
#include "core/study/goniometer/patch.h"

#include <span>

namespace reflectance {

struct TiledRay {
    Vec3d P; ///< origin; where a facet is met, the point on it, inside the period
    Vec3d d; ///< unit
    bool active = true;
    enum class End { Sky, Facet, Lost } end = End::Sky;
    Vec3d n{}; ///< of the facet met: unit, towards the side that the ray comes from
};

class TiledRays {
public:
    explicit TiledRays(const Patch& patch);

    /// Brings each active ray to the first facet that it meets, or to the sky. Lost: fell through the surface, or ran
    /// 100000 periods without rising out of it; neither happens but by rounding.
    void trace(std::span<TiledRay> rays) const;

    [[nodiscard]] double top() const { return top_; } ///< a height that no facet reaches
    [[nodiscard]] double width() const { return width_; }
    [[nodiscard]] double depth() const { return depth_; }

    /// Rays that leave a facet start this far above it: some twenty roundings of Embree's floats.
    static constexpr double lift = 1e-6;

private:
    void traceEight(std::span<TiledRay> rays) const;
    void meet(TiledRay& ray, std::uint32_t triangle) const;
    [[nodiscard]] bool wrapped(TiledRay& ray, double along) const;

    double width_, depth_;
    double top_ = 0.0, bottom_ = 0.0;
    RayScene scene_;
    std::vector<Vec3d> normals_; ///< unit, one per triangle; (0,0,0) where it has no area
};

} // namespace reflectance
