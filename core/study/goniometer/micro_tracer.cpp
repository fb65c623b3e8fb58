#include "core/study/goniometer/micro_tracer.h"

#include "core/math/matrix3.h"
#include "core/reflectance/shade_block.h"

#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr std::size_t batchSize = MicroTracer::batchSize;
static_assert(batchSize == blockSize, "a batch is one block of the kernels");

/// One number in each of batchSize even strata, in random order.
using Strata = std::array<double, batchSize>;
Strata shuffledStrata(CounterRandom& random)
{
    Strata strata;
    for (std::size_t i = 0; i < batchSize; ++i) {
        const std::size_t j = random.below(i + 1); // inside out: Durstenfeld 1964
        strata[i] = strata[j];
        strata[j] = (static_cast<double>(i) + random.next()) / batchSize;
    }
    return strata;
}

/// By -angle about z, after y was mirrored where asked for: from the table's frame into the patch's.
Vec3d intoPatch(const Vec3d& v, double angle, bool mirror)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double y = mirror ? -v.y : v.y;
    return {c * v.x + s * y, c * y - s * v.x, v.z};
}

/// Cosine-distributed about n, from two numbers in 0 .. 1 (Malley's method about any axis).
Vec3d cosineAbout(const Vec3d& n, double u, double v)
{
    const double r = std::sqrt(u);
    const Vec3d aside = std::fabs(n.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
    const Vec3d t = normalized(cross(aside, n));
    const Vec3d b = cross(n, t);
    return normalized(r * std::cos(turn * v) * t + r * std::sin(turn * v) * b + std::sqrt(1.0 - u) * n);
}

void add(Mat3d& sum, const Mat3d& m)
{
    for (int row = 0; row < 3; ++row)
        sum.rows[row] += m.rows[row];
}

Mat3d times(const Mat3d& m, double s)
{
    return {{s * m.rows[0], s * m.rows[1], s * m.rows[2]}};
}

bool isZero(const Mat3d& m)
{
    return m.rows[0] == Vec3d() && m.rows[1] == Vec3d() && m.rows[2] == Vec3d();
}

} // namespace

MicroTracer::MicroTracer(const MicroSurface& surface, Facets facets, const Effects& effects)
    : facets_(std::move(facets)), effects_(effects)
{
    patches_.reserve(surface.patches.size());
    for (const Patch& patch : surface.patches)
        patches_.emplace_back(patch);
}

MicroTracer::Batch MicroTracer::trace(const DirectionPair& directions, std::optional<double> azimuth,
                                      CounterRandom random) const
{
    Paths paths;
    Batch batch;
    start(paths, directions, azimuth, random);
    meetFirst(paths, batch);
    addLight(paths, batch);
    for (int k = 0; k < effects_.bounces; ++k) {
        bounce(paths, random, batch, nullptr);
        addLight(paths, batch);
    }
    batch.factor = times(batch.factor, 1.0 / batchSize);
    return batch;
}

Vec3d MicroTracer::furnace(const Vec3d& V, std::optional<double> azimuth, CounterRandom random) const
{
    Paths paths;
    Batch batch;
    Vec3d sky;
    start(paths, {{0, 0, 1}, V}, azimuth, random);
    meetFirst(paths, batch);
    for (int k = 0; k <= effects_.bounces; ++k)
        bounce(paths, random, batch, &sky);
    return sky / static_cast<double>(batchSize);
}

void MicroTracer::start(Paths& paths, const DirectionPair& directions, std::optional<double> azimuth,
                        CounterRandom& random) const
{
    const Strata x = shuffledStrata(random);
    const Strata y = shuffledStrata(random);
    const Strata turned = shuffledStrata(random);
    const double offset = random.next();
    const auto count = static_cast<double>(patches_.size());
    for (std::size_t i = 0; i < batchSize; ++i) {
        Path& path = paths[i];
        // Patches in order, so that eight neighbouring paths mostly share one; which of them gets one more varies.
        path.patch = static_cast<std::size_t>((static_cast<double>(i) + offset) * count / batchSize) % patches_.size();
        const TiledRays& patch = patches_[path.patch];
        const bool mirror = !azimuth && turned[i] >= 0.5;
        const double angle = azimuth ? *azimuth : 2.0 * turn * turned[i];
        path.V = intoPatch(directions.V, angle, mirror);
        path.L = intoPatch(directions.L, angle, mirror);
        path.weight = diagonalMatrix(Vec3d(1.0));
        path.alive = true;
        path.ray = {{x[i] * patch.width(), y[i] * patch.depth(), patch.top()}, -path.V};
    }
}

/// Rays of even density on the mean plane see the surface as the viewer does. Without masking every facet is seen, with the
/// area that it turns to the viewer.
void MicroTracer::meetFirst(Paths& paths, Batch& batch) const
{
    if (!effects_.masking)
        for (Path& path : paths)
            path.ray.d = {0, 0, -1};
    traceAlong(paths);
    for (Path& path : paths) {
        path.alive = path.ray.end == TiledRay::End::Facet;
        batch.lost += path.alive ? 0 : 1;
        if (path.alive && !effects_.masking)
            path.weight = times(path.weight, std::max(0.0, dot(path.ray.n, path.V)) / (path.ray.n.z * path.V.z));
    }
}

void MicroTracer::traceAlong(Paths& paths) const
{
    std::array<TiledRay, batchSize> rays;
    for (std::size_t i = 0; i < batchSize; ++i) {
        rays[i] = paths[i].ray;
        rays[i].active = paths[i].alive;
    }
    for (std::size_t first = 0; first < batchSize;) {
        std::size_t last = first;
        while (last < batchSize && paths[last].patch == paths[first].patch)
            ++last;
        patches_[paths[first].patch].trace(std::span(rays).subspan(first, last - first));
        first = last;
    }
    for (std::size_t i = 0; i < batchSize; ++i)
        if (paths[i].alive)
            paths[i].ray = rays[i];
}

void MicroTracer::shade(const Paths& paths, const std::array<bool, batchSize>& takesPart,
                        std::array<Mat3d, batchSize>& factors, const std::array<Vec3d, batchSize>& L) const
{
    ShadeBlock<double> block;
    block.lightDisc.fill(0.0);
    std::array<std::size_t, batchSize> path{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < batchSize; ++i) {
        if (!takesPart[i])
            continue;
        block.N.set(count, paths[i].ray.n);
        block.V.set(count, paths[i].V);
        block.L.set(count, L[i]);
        path[count++] = i;
    }
    const auto underLight = [&](const Vec3d& I) {
        block.I.fill(I);
        block.sum.fill({});
        facets_.model->exact.shade(facets_.values.data(), block.batch(count));
    };
    if (facets_.channels < 9) {
        underLight(Vec3d(1.0));
        for (std::size_t k = 0; k < count; ++k)
            factors[path[k]] = diagonalMatrix(block.sum[k]);
        return;
    }
    constexpr Vec3d primaries[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int column = 0; column < 3; ++column) {
        underLight(primaries[column]);
        for (std::size_t k = 0; k < count; ++k) {
            Mat3d& m = factors[path[k]];
            const Vec3d seen = block.sum[k];
            (column == 0 ? m.rows[0].x : column == 1 ? m.rows[0].y : m.rows[0].z) = seen.x;
            (column == 0 ? m.rows[1].x : column == 1 ? m.rows[1].y : m.rows[1].z) = seen.y;
            (column == 0 ? m.rows[2].x : column == 1 ? m.rows[2].y : m.rows[2].z) = seen.z;
        }
    }
}

void MicroTracer::addLight(Paths& paths, Batch& batch) const
{
    Paths shadowRays = paths;
    std::array<bool, batchSize> isLit{};
    std::array<Vec3d, batchSize> L;
    for (std::size_t i = 0; i < batchSize; ++i) {
        const Path& path = paths[i];
        L[i] = path.L;
        isLit[i] = path.alive && dot(path.ray.n, path.L) > 0.0;
        shadowRays[i].alive = isLit[i];
        shadowRays[i].ray = {path.ray.P + TiledRays::lift * path.ray.n, path.L};
    }
    if (effects_.shadowing) {
        traceAlong(shadowRays);
        for (std::size_t i = 0; i < batchSize; ++i)
            isLit[i] = isLit[i] && shadowRays[i].ray.end == TiledRay::End::Sky;
    }
    std::array<Mat3d, batchSize> factors;
    shade(paths, isLit, factors, L);
    for (std::size_t i = 0; i < batchSize; ++i)
        if (isLit[i])
            add(batch.factor, paths[i].weight * factors[i]);
}

/// What arrives from a direction W and leaves towards V has the weight factor(W, V) / pi dW; with W cosine-distributed about n,
/// factor / (n.W).
void MicroTracer::bounce(Paths& paths, CounterRandom& random, Batch& batch, Vec3d* sky) const
{
    std::array<bool, batchSize> isAlive{};
    std::array<Vec3d, batchSize> W;
    for (std::size_t i = 0; i < batchSize; ++i) {
        const double u = random.next(); // whether alive or not: a path's numbers do not depend on the others
        const double v = random.next();
        isAlive[i] = paths[i].alive;
        if (isAlive[i])
            W[i] = cosineAbout(paths[i].ray.n, u, v);
    }
    std::array<Mat3d, batchSize> factors;
    shade(paths, isAlive, factors, W);
    for (std::size_t i = 0; i < batchSize; ++i) {
        Path& path = paths[i];
        const double cosine = isAlive[i] ? dot(path.ray.n, W[i]) : 0.0;
        if (cosine > 0.0)
            path.weight = times(path.weight * factors[i], 1.0 / cosine);
        path.alive = cosine > 0.0 && !isZero(path.weight);
        if (!path.alive)
            continue;
        path.ray = {path.ray.P + TiledRays::lift * path.ray.n, W[i]};
        path.V = -W[i];
    }
    traceAlong(paths);
    for (Path& path : paths) {
        if (path.alive && path.ray.end == TiledRay::End::Sky && sky)
            *sky += path.weight * Vec3d(1.0);
        batch.lost += path.alive && path.ray.end == TiledRay::End::Lost ? 1 : 0;
        path.alive = path.alive && path.ray.end == TiledRay::End::Facet;
    }
}

} // namespace reflectance
