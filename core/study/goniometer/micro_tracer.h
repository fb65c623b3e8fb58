// What leaves a micro-surface: paths of light between its facets, traced from the viewer.
#pragma once

#include "core/measured/angles.h"
#include "core/reflectance/catalogue.h"
#include "core/study/goniometer/counter_random.h"
#include "core/study/goniometer/micro_surface.h"
#include "core/study/goniometer/tiled_rays.h"

#include <array>
#include <optional>

namespace reflectance {

/// What every facet is made of: a model about the facet's own normal.
struct Facets {
    const Model* model = nullptr;
    std::vector<double> values; ///< the model's flat list
    std::size_t channels = 1;   ///< 1, 3 or 9, see channelsOf(model, values)
};

/// What light may do between facets. Leaving something out shows what it contributes.
struct Effects {
    bool masking = true;   ///< a facet hides another from the viewer
    bool shadowing = true; ///< a facet keeps the light from another
    int bounces = 0;       ///< most reflections from facet to facet before the one to the viewer; 0: single reflection

    friend bool operator==(const Effects&, const Effects&) = default;
};
inline constexpr int mostBounces = 1000;

class MicroTracer {
public:
    /// Paths are traced in batches of this size, spread evenly over the patch (Latin hypercube sampling: McKay, Beckman
    /// and Conover 1979). The mean of a batch is unbiased; the spread of batches tells its error.
    static constexpr std::size_t batchSize = 256;

    MicroTracer(const MicroSurface& surface, Facets facets, const Effects& effects);

    struct Batch {
        Mat3d factor; ///< mean over the paths: the lecture's factor pi f (N.L) as a matrix, diagonal below 9 channels
        std::size_t lost = 0; ///< rays that fell through the surface: counted as black
    };

    /// L and V are unit vectors above the mean plane. The surface lies turned by `azimuth` (radians, counter-clockwise); without
    /// one each path meets it turned by another angle and mirrored every other time: an isotropic mixture.
    [[nodiscard]] Batch trace(const DirectionPair& directions, std::optional<double> azimuth,
                              CounterRandom random) const;

    /// What a viewer sees where radiance 1 arrives from everywhere, mean over one batch and the channels' white: 1 where nothing
    /// is absorbed. Light that would need more than the effects' bounces + 1 reflections is missing.
    [[nodiscard]] Vec3d furnace(const Vec3d& V, std::optional<double> azimuth, CounterRandom random) const;

    [[nodiscard]] const Facets& facets() const { return facets_; }

private:
    struct Path {
        TiledRay ray;
        Vec3d V, L; ///< in the patch's own frame; V is where the path's light goes next
        Mat3d weight;
        std::size_t patch = 0;
        bool alive = true;
    };
    using Paths = std::array<Path, batchSize>;

    void start(Paths& paths, const DirectionPair& directions, std::optional<double> azimuth,
               CounterRandom& random) const;
    void meetFirst(Paths& paths, Batch& batch) const;
    void addLight(Paths& paths, Batch& batch) const;
    void bounce(Paths& paths, CounterRandom& random, Batch& batch, Vec3d* sky) const;
    void traceAlong(Paths& paths) const;
    /// The facets' factor at each path that takes part: as a matrix.
    void shade(const Paths& paths, const std::array<bool, batchSize>& takesPart, std::array<Mat3d, batchSize>& factors,
               const std::array<Vec3d, batchSize>& L) const;

    std::vector<TiledRays> patches_;
    Facets facets_;
    Effects effects_;
};

} // namespace reflectance
