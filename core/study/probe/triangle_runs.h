// Which triangles of a mesh a ray could meet: they lie in runs, and around each run is a sphere.
#pragma once

#include "core/geometry/mesh.h"

#include <algorithm>
#include <memory>

namespace reflectance {

class TriangleRuns {
public:
    explicit TriangleRuns(const Mesh& mesh);

    /// Calls visit(i) in ascending order for every triangle of the runs whose sphere the line through the eye along a unit
    /// direction comes near. Files list neighbours one after the other, so these are few; in any order they are enough.
    template <class Visit> void along(const Vec3d& eye, const Vec3d& direction, const Visit& visit) const
    {
        for (std::size_t run = 0; run < spheres_.size(); ++run)
            if (isNear(spheres_[run], eye, direction))
                for (std::size_t i = run * runLength; i < std::min((run + 1) * runLength, triangles_); ++i)
                    visit(i);
    }

private:
    static constexpr std::size_t runLength = 64;

    struct Sphere {
        Vec3d centre;
        double radius;
    };

    /// With room for the rounding of the test itself and of those that follow.
    static bool isNear(const Sphere& sphere, const Vec3d& eye, const Vec3d& direction)
    {
        const Vec3d away = sphere.centre - eye;
        const Vec3d across = cross(away, direction);
        const double reach = sphere.radius * (1.0 + 1e-9) + 1e-12 * dot(away, away);
        return !(dot(across, across) > reach * reach);
    }

    static Sphere around(const Mesh& mesh, std::size_t first, std::size_t last);

    std::size_t triangles_;
    std::vector<Sphere> spheres_;
};

/// The runs of a mesh, remembered while it is the last that was asked for; from any thread.
[[nodiscard]] std::shared_ptr<const TriangleRuns> runsOf(const std::shared_ptr<const Mesh>& mesh);

} // namespace reflectance
