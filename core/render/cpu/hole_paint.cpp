#include "core/render/cpu/hole_paint.h"

#include "core/scene/requirements.h"

#include <algorithm>

namespace reflectance {

bool showsHoles(const Scene& scene)
{
    return requirementsOf(scene).holes;
}

template <class T>
void paintHoles(const ViewSamples& samples, const Scene& scene, std::size_t first, std::size_t count,
                Vec3Column<T>& sum)
{
    const Table& table = scene.surface.table->table;
    const std::vector<Light> lights = shiningLights(scene);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t s = first + i;
        const Vec3d P{samples.Px[s], samples.Py[s], samples.Pz[s]};
        const Vec3d N{samples.Nx[s], samples.Ny[s], samples.Nz[s]};
        const Vec3d V = normalized(samples.eye - P);
        const auto meetsHole = [&](const Light& light) {
            return !(light.intensity == Vec3d()) && isHoleAt(table, N, arrivalAt(light, P).L, V);
        };
        if (std::any_of(lights.begin(), lights.end(), meetsHole))
            sum.set(i, holeColor(P));
    }
}

template void paintHoles(const ViewSamples&, const Scene&, std::size_t, std::size_t, Vec3Column<double>&);
template void paintHoles(const ViewSamples&, const Scene&, std::size_t, std::size_t, Vec3Column<float>&);

} // namespace reflectance
