// Milliseconds per 1024 x 1024 picture of the default scene: shading kept samples again, and finding them, the latter
// beside what Embree alone needs for the same rays.
#include "core/render/cpu/cpu_renderer.h"
#include "core/render/cpu/pixel_rays.h"
#include "core/render/cpu/ray_scene.h"
#include "tests/benchmarks/alternate.h"
#include "tests/benchmarks/knot.h"

#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>
#include <limits>
#include <tbb/parallel_for.h>

namespace reflectance {
namespace {

constexpr RenderSettings large{1024, 1024, 1};

void reshade(benchmark::State& state)
{
    const Scene scene = defaultScene();
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, large);
    const auto precision = static_cast<Precision>(state.range(0));
    state.SetLabel(std::string(nameOf(precision)));
    for (auto _ : state)
        benchmark::DoNotOptimize(shadeSamples(samples, scene, precision));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(samples.count()));
}
BENCHMARK(reshade)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();

void visibility(benchmark::State& state)
{
    const Scene scene = defaultScene();
    const auto rays = makeRayScene(scene.mesh);
    for (auto _ : state)
        benchmark::DoNotOptimize(sampleView(*rays, scene.camera, large));
    state.SetItemsProcessed(state.iterations() * large.width * large.height);
}
BENCHMARK(visibility)->Unit(benchmark::kMillisecond)->UseRealTime();

struct BareEmbree {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);

    explicit BareEmbree(const Mesh& mesh)
    {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
        for (const Vec3d& p : mesh.positions)
            for (const double coordinate : {p.x, p.y, p.z})
                *vertices++ = static_cast<float>(coordinate);
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Mesh::Triangle), mesh.triangles.size()));
        for (const Mesh::Triangle& triangle : mesh.triangles)
            indices = std::copy(triangle.begin(), triangle.end(), indices);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
    }
    BareEmbree(const BareEmbree&) = delete;
    BareEmbree& operator=(const BareEmbree&) = delete;
    ~BareEmbree()
    {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
};

/// Embree's packets by their number of rays.
template <int N> struct EmbreePacket;
template <> struct EmbreePacket<8> {
    using Rays = RTCRayHit8;
    static constexpr auto intersect = rtcIntersect8;
};
template <> struct EmbreePacket<16> {
    using Rays = RTCRayHit16;
    static constexpr auto intersect = rtcIntersect16;
};

template <int N> struct alignas(64) Packet {
    typename EmbreePacket<N>::Rays rays;
};

/// Packets of four columns and N / 4 rows of pixels.
template <int N> std::vector<Packet<N>> packetsOf(const Camera& camera)
{
    const PixelRays pixelRays(camera, large);
    std::vector<Packet<N>> packets;
    for (int y = 0; y < large.height; y += N / 4)
        for (int x = 0; x < large.width; x += 4) {
            Packet<N>& packet = packets.emplace_back();
            for (int i = 0; i < N; ++i) {
                const Vec3d direction = pixelRays.throughSample(x + i % 4, y + i / 4, 0);
                packet.rays.ray.org_x[i] = static_cast<float>(camera.eye.x);
                packet.rays.ray.org_y[i] = static_cast<float>(camera.eye.y);
                packet.rays.ray.org_z[i] = static_cast<float>(camera.eye.z);
                packet.rays.ray.dir_x[i] = static_cast<float>(direction.x);
                packet.rays.ray.dir_y[i] = static_cast<float>(direction.y);
                packet.rays.ray.dir_z[i] = static_cast<float>(direction.z);
                packet.rays.ray.mask[i] = 0xFFFFFFFF;
            }
        }
    return packets;
}

/// The same rays, ready made, and nothing done with what they meet.
template <int N> void traceAll(const BareEmbree& embree, std::vector<Packet<N>>& packets)
{
    tbb::parallel_for(std::size_t{0}, packets.size() / 64, [&](std::size_t task) {
        alignas(64) int valid[N];
        std::fill(std::begin(valid), std::end(valid), -1);
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (std::size_t i = 64 * task; i < 64 * (task + 1); ++i) {
            auto& rays = packets[i].rays;
            for (int lane = 0; lane < N; ++lane) {
                rays.ray.tfar[lane] = std::numeric_limits<float>::infinity();
                rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
            }
            EmbreePacket<N>::intersect(valid, embree.scene, &context, &rays);
        }
    });
}

/// Times `frame` against the rays alone, Embree's structures being there.
template <int N, class Frame> void againstRays(benchmark::State& state, const Frame& frame)
{
    Scene scene = defaultScene();
    scene.mesh = bench::knotMesh(state.range(0));
    const auto precision = static_cast<Precision>(state.range(1));
    state.SetLabel(std::string(nameOf(precision)));
    const auto rays = makeRayScene(scene.mesh);
    const BareEmbree embree(*scene.mesh);
    std::vector<Packet<N>> packets = packetsOf<N>(scene.camera);
    bench::alternate(
        state, [&] { benchmark::DoNotOptimize(frame(*rays, scene, precision)); }, [&] { traceAll(embree, packets); });
}

/// A first frame: rays, points in double, shading; against packets of 8 or 16 rays.
template <int N> void firstFrameCpu(benchmark::State& state)
{
    againstRays<N>(state, [](const RayScene& rays, const Scene& scene, Precision precision) {
        return renderOnCpu(rays, scene, large, precision);
    });
}

/// The same with its samples kept, to be shaded again.
void keptFrameCpu(benchmark::State& state)
{
    againstRays<8>(state, [](const RayScene& rays, const Scene& scene, Precision precision) {
        return shadeSamples(sampleView(rays, scene.camera, large), scene, precision);
    });
}

void bothMeshes(benchmark::internal::Benchmark* benchmark)
{
    benchmark
        ->ArgsProduct({{100'000, 1'000'000}, {static_cast<int>(Precision::Double), static_cast<int>(Precision::Simd)}})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}
BENCHMARK_TEMPLATE(firstFrameCpu, 8)->Apply(bothMeshes);
BENCHMARK_TEMPLATE(firstFrameCpu, 16)->Apply(bothMeshes);
BENCHMARK(keptFrameCpu)->Apply(bothMeshes);

} // namespace
} // namespace reflectance
