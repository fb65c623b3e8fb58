#include "core/geometry/load.h"
#include "core/study/bench/ball.h"
#include "core/study/bench/bench.h"
#include "core/study/bench/interleaved.h"

namespace reflectance {

std::vector<LoadCost> loadCosts(const BenchEffort& effort, Progress& progress)
{
    const auto mesh = ball(effort.rows); // as many triangles as directions elsewhere
    const std::string files[] = {objOf(*mesh), plyOf(*mesh)};
    const std::pair<const char*, const char*> names[] = {{"OBJ text", "ball.obj"}, {"PLY, binary", "ball.ply"}};
    std::vector<LoadCost> costs;
    std::vector<TimedWork> works;
    for (std::size_t i = 0; i < 2; ++i) {
        costs.push_back({names[i].first, mesh->triangles.size(), static_cast<double>(files[i].size()) * 1e-6, {}});
        works.emplace_back(byTheWall([&, i] { static_cast<void>(readMesh(files[i], names[i].second)); }));
    }
    const auto timings = interleaved(works, effort.repetitions, 1.0, progress, 1.0);
    for (std::size_t i = 0; i < timings.size(); ++i)
        costs[i].milliseconds = timings[i];
    return costs;
}

} // namespace reflectance
