// What shading, frames and loading cost on this machine. Repetitions are interleaved, so that whatever disturbs the machine
// for a while disturbs all alike; a figure is their median, its spread half the distance between the quartiles.
#pragma once

#include "core/reflectance/arithmetic.h"
#include "core/render/gl/gl_renderer.h"
#include "core/render/progress.h"
#include "core/study/cost/timing.h"

#include <optional>
#include <string>
#include <vector>

namespace reflectance {

struct BenchEffort {
    std::size_t rows = std::size_t{1} << 18U; ///< directions per batch
    int repetitions = 9;
};

/// Few directions and repetitions: seconds instead of a minute.
[[nodiscard]] constexpr BenchEffort quickEffort()
{
    return {std::size_t{1} << 14U, 3};
}

/// Nanoseconds per pair of directions and light, one core; parameters at their defaults.
struct KernelCost {
    std::string model;
    std::string precision; ///< "simd (avx2)"
    Timing nanoseconds;
};

/// Every model in double, float and SIMD, the hybrid also in each form of the lobe (SIMD).
[[nodiscard]] std::vector<KernelCost> kernelCosts(const BenchEffort& effort, Progress& progress);

/// Milliseconds per picture of a scene.
struct FrameCost {
    std::string renderer;    ///< "double", "float", "simd (avx2)", "glsl"
    Timing shading;          ///< again, samples kept
    double firstFrame = 0.0; ///< visibility and shading from nothing, once
};

/// GL only where a renderer is given; its context must be current.
[[nodiscard]] Result<std::vector<FrameCost>> frameCosts(const Scene& scene, const RenderSettings& settings,
                                                        GlRenderer* gl, const BenchEffort& effort, Progress& progress);

/// From bytes in memory to a mesh that can be drawn.
struct LoadCost {
    std::string format; ///< "OBJ text", "PLY, binary"
    std::size_t triangles = 0;
    double megabytes = 0.0;
    Timing milliseconds;

    [[nodiscard]] double megabytesPerSecond() const { return megabytes / (milliseconds.median * 1e-3); }
};

/// A sphere of our own in each format.
[[nodiscard]] std::vector<LoadCost> loadCosts(const BenchEffort& effort, Progress& progress);

} // namespace reflectance
