#include "core/render/cpu/sample_shader.h"

#include "core/render/cpu/hole_paint.h"

#include <algorithm>

namespace reflectance {
namespace {

template <class T> Vec3<T> radianceThere(const void* environment, const Vec3<T>& direction)
{
    return radianceFrom(*static_cast<const Environment*>(environment), direction);
}

template <class T>
void directionsByDouble(const Vec3d& point, const ViewSamples& samples, std::size_t first, std::size_t count,
                        Vec3Column<T>& directions, std::array<T, blockSize>& distances)
{
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t s = first + i;
        const Vec3d away = point - Vec3d{samples.Px[s], samples.Py[s], samples.Pz[s]};
        directions.set(i, normalized(away));
        distances[i] = static_cast<T>(length(away));
    }
}

/// Unit vectors from sample positions to a point, and their distances. The difference is taken in double and rounded
/// once; a sample at the very point gets the zero vector.
void directionsTo(const Vec3d& point, const ViewSamples& samples, std::size_t first, std::size_t count,
                  Vec3Column<double>& directions, std::array<double, blockSize>& distances)
{
    directionsByDouble(point, samples, first, count, directions, distances);
}

void directionsTo(const Vec3d& point, const ViewSamples& samples, std::size_t first, std::size_t count,
                  Vec3Column<float>& directions, std::array<float, blockSize>& distances)
{
    int extreme = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(point.x - samples.Px[first + i]);
        const auto y = static_cast<float>(point.y - samples.Py[first + i]);
        const auto z = static_cast<float>(point.z - samples.Pz[first + i]);
        const float squared = x * x + y * y + z * z;
        extreme |= static_cast<int>(!(squared > 1e-30F)) | static_cast<int>(!(squared < 1e30F));
        const float distance = std::sqrt(squared);
        const float scale = 1.0F / distance;
        directions.x[i] = x * scale;
        directions.y[i] = y * scale;
        directions.z[i] = z * scale;
        distances[i] = distance;
    }
    if (extreme != 0) // squares that floats cannot hold (hazards H40, H41): the whole block again, with care
        directionsByDouble(point, samples, first, count, directions, distances);
}

/// I / r^2 with the smallest distance that counts; 0 at the light itself (hazard H40).
template <class T>
void intensitiesAt(const Light& light, const std::array<T, blockSize>& distances, std::size_t count,
                   Vec3Column<T>& intensities)
{
    const Vec3<T> I(light.intensity);
    const T smallest = static_cast<T>(smallestLightDistance);
    for (std::size_t i = 0; i < count; ++i) {
        const T r = distances[i] > smallest ? distances[i] : smallest;
        const T factor = distances[i] > T(0) ? T(1) / (r * r) : T(0);
        intensities.x[i] = I.x * factor;
        intensities.y[i] = I.y * factor;
        intensities.z[i] = I.z * factor;
    }
}

} // namespace

template <class T>
SampleShader<T>::SampleShader(const Scene& scene, const Kernel<T>& kernel, std::vector<double> values,
                              bool looksAtViewer)
    : kernel_(kernel), values_(std::move(values)), scene_(scene),
      measured_(lookUpsIn(scene.surface.table.get()).in<T>()), paintsHoles_(showsHoles(scene)),
      looksAtViewer_(looksAtViewer)
{
    for (const Light& light : shiningLights(scene)) {
        if (light.kind == LightKind::Point) {
            point_.push_back(light);
            continue;
        }
        const Arrival arrival = arrivalAt(light, {});
        LightColumns& columns = directional_.emplace_back();
        columns.L.fill(arrival.L);
        columns.I.fill(arrival.I);
        columns.lightDisc.fill(static_cast<T>(discOf(light)));
    }
    if (kernel_.environment != nullptr && scene.environment.kind != EnvironmentKind::None)
        surroundings_ = {radianceThere<T>, &scene.environment};
}

template <class T>
void SampleShader<T>::load(const ViewSamples& samples, std::size_t first, std::size_t count, ShadeBlock<T>& block) const
{
    const auto rounded = [](double number) { return static_cast<T>(number); };
    std::transform(&samples.Nx[first], &samples.Nx[first] + count, block.N.x.begin(), rounded);
    std::transform(&samples.Ny[first], &samples.Ny[first] + count, block.N.y.begin(), rounded);
    std::transform(&samples.Nz[first], &samples.Nz[first] + count, block.N.z.begin(), rounded);
    block.sum.fill({});
    if (!looksAtViewer_) {
        block.V.fill({});
        return;
    }
    alignas(64) std::array<T, blockSize> distances;
    directionsTo(samples.eye, samples, first, count, block.V, distances);
}

template <class T>
void SampleShader<T>::addLight(const LightColumns& light, std::size_t count, ShadeBlock<T>& block) const
{
    kernel_.shade(values_.data(), {count, block.N.read(), light.L.read(), block.V.read(), light.I.read(),
                                   light.lightDisc.data(), block.sum.write(), measured_});
}

template <class T>
void SampleShader<T>::shade(const ViewSamples& samples, std::size_t first, std::size_t count,
                            ShadeBlock<T>& block) const
{
    load(samples, first, count, block);
    for (const LightColumns& light : directional_)
        addLight(light, count, block);
    for (const Light& light : point_) {
        LightColumns columns;
        alignas(64) std::array<T, blockSize> distances;
        directionsTo(light.position, samples, first, count, columns.L, distances);
        intensitiesAt(light, distances, count, columns.I);
        columns.lightDisc.fill(static_cast<T>(discOf(light)));
        addLight(columns, count, block);
    }
    if (surroundings_.radiance != nullptr)
        kernel_.environment(values_.data(), block.environmentBatch(count, surroundings_));
    if (paintsHoles_)
        paintHoles(samples, scene_, first, count, block.sum);
}

template class SampleShader<double>;
template class SampleShader<float>;

} // namespace reflectance
