// From a mesh file, warm in the page cache, to a mesh that can be drawn with smooth normals: this program's reader
// against OpenMesh's own, and against what reading alone costs. `peak/mesh` is the most memory that reading took, over
// the size of the mesh that came out.
#include "core/geometry/load.h"
#include "tests/benchmarks/knot.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <benchmark/benchmark.h>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

namespace reflectance::bench {
namespace {

constexpr double bytesOf(const Mesh& mesh)
{
    return static_cast<double>(mesh.positions.size() * sizeof(Vec3d) + mesh.normals.size() * sizeof(Vec3d) +
                               mesh.fileVertex.size() * sizeof(std::uint32_t) +
                               mesh.triangles.size() * sizeof(Mesh::Triangle));
}

double kilobytes(const char* name)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name))
            return std::strtod(line.c_str() + std::strlen(name), nullptr);
    return 0.0;
}

/// In a process of its own, so that nothing freed earlier hides anything: most memory while reading, over the mesh's.
double peakOverMesh(const std::string& path)
{
    int ends[2];
    if (::pipe(ends) != 0)
        return 0.0;
    const pid_t child = ::fork();
    if (child == 0) {
        std::ofstream("/proc/self/clear_refs") << "5\n"; // VmHWM begins anew
        const double before = kilobytes("VmRSS:");
        const auto loaded = loadMesh(path);
        const double ratio = loaded ? 1024.0 * (kilobytes("VmHWM:") - before) / bytesOf(*loaded->mesh) : -1.0;
        const bool isSent = ::write(ends[1], &ratio, sizeof ratio) == sizeof ratio;
        ::_exit(isSent ? 0 : 1);
    }
    double ratio = 0.0;
    if (::read(ends[0], &ratio, sizeof ratio) != sizeof ratio)
        ratio = -1.0;
    ::close(ends[0]);
    ::close(ends[1]);
    ::waitpid(child, nullptr, 0);
    return ratio;
}

void count(benchmark::State& state, const std::string& path)
{
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(std::filesystem::file_size(path)));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void load(benchmark::State& state, KnotNormals normals)
{
    const std::string path = knotFile(state.range(0), normals);
    for (auto _ : state)
        if (!loadMesh(path))
            state.SkipWithError("not read");
    count(state, path);
    state.counters["peak/mesh"] = peakOverMesh(path);
}

void loadObj(benchmark::State& state)
{
    load(state, KnotNormals::InFile);
}
void loadObjAndSmooth(benchmark::State& state)
{
    load(state, KnotNormals::None);
}

void loadPly(benchmark::State& state)
{
    const std::string bytes = knotPly(state.range(0));
    for (auto _ : state)
        if (!readMesh(bytes, "knot.ply"))
            state.SkipWithError("not read");
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// OpenMesh's reader, which makes its half-edge structure on the way, and its vertex normals where the file has none.
void openMesh(benchmark::State& state, KnotNormals normals)
{
    using Halfedges = OpenMesh::TriMesh_ArrayKernelT<>;
    const std::string path = knotFile(state.range(0), normals);
    for (auto _ : state) {
        Halfedges mesh;
        mesh.request_vertex_normals();
        OpenMesh::IO::Options options = OpenMesh::IO::Options::VertexNormal;
        if (!OpenMesh::IO::read_mesh(mesh, path, options))
            state.SkipWithError("not read");
        if (normals == KnotNormals::None) {
            mesh.request_face_normals();
            mesh.update_normals();
        }
        benchmark::DoNotOptimize(mesh.n_faces());
    }
    count(state, path);
}
void openMeshObj(benchmark::State& state)
{
    openMesh(state, KnotNormals::InFile);
}
void openMeshObjAndSmooth(benchmark::State& state)
{
    openMesh(state, KnotNormals::None);
}

/// What moving the file's bytes costs, and nothing else.
void readBytes(benchmark::State& state)
{
    const std::string path = knotFile(state.range(0), KnotNormals::InFile);
    std::string bytes(std::filesystem::file_size(path), '\0');
    for (auto _ : state)
        if (!std::ifstream(path, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
            state.SkipWithError("not read");
    count(state, path);
}

constexpr std::int64_t million = 1'000'000;

BENCHMARK(loadObj)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(million)
    ->Arg(5 * million)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(loadObjAndSmooth)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(million)
    ->Arg(5 * million)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(loadPly)->Arg(100'000)->Arg(million)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(openMeshObj)->Arg(100'000)->Arg(million)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(openMeshObjAndSmooth)
    ->Arg(100'000)
    ->Arg(million)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);
BENCHMARK(readBytes)->Arg(million)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace reflectance::bench
