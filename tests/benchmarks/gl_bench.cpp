// The GL renderer through OSMesa against a minimal forward program with the same arithmetic: 1024 x 1024, one sample per
// pixel, hybrid. Frames of the two alternate in one loop, so that a busy machine slows both; `ratio` is what counts.
#include "core/render/gl/gl_renderer.h"
#include "core/render/headless/headless_context.h"
#include "tests/benchmarks/alternate.h"
#include "tests/benchmarks/forward_gl.h"
#include "tests/benchmarks/knot.h"

#include <cstdlib>

namespace reflectance::bench {
namespace {

constexpr int side = 1024;
constexpr RenderSettings settings{side, side, 1};

Scene sceneOf(std::int64_t triangles, std::int64_t lights)
{
    Scene scene = defaultScene();
    scene.mesh = knotMesh(triangles);
    scene.surface = {};
    scene.surface.model = "hybrid";
    const Light first = scene.lights.front();
    scene.lights.assign(static_cast<std::size_t>(lights), first);
    return scene;
}

struct Pair {
    std::unique_ptr<HeadlessContext> context = *openHeadless(ContextKind::OsMesa);
    Scene scene;
    GlRenderer renderer = *GlRenderer::create(context->loader());
    ForwardGl forward;

    Pair(std::int64_t triangles, std::int64_t lights)
        : scene(sceneOf(triangles, lights)), forward(context->loader(), scene, side)
    {
    }

    /// Up to the float buffer in which the yardstick ends too, or through the sensor as well.
    void render(bool developed)
    {
        if (!(developed ? renderer.render(scene, settings) : renderer.renderLinear(scene, settings)))
            std::abort();
        renderer.finish();
    }
};

/// A camera that moves a little each time: visibility and shading anew, nothing uploaded.
void moveCamera(benchmark::State& state, bool developed)
{
    Pair pair(state.range(0), state.range(1));
    const Camera rest = pair.scene.camera;
    int frame = 0;
    alternate(
        state,
        [&] {
            pair.scene.camera = rest;
            pair.scene.camera.eye.x += 0.001 * (++frame % 7);
            pair.render(developed);
        },
        [&] {
            pair.forward.drawMesh(pair.scene.camera);
            pair.forward.finish();
        });
}
void firstFrame(benchmark::State& state)
{
    moveCamera(state, false);
}
void firstFrameDeveloped(benchmark::State& state)
{
    moveCamera(state, true);
}
BENCHMARK(firstFrame)
    ->ArgsProduct({{10'000, 100'000, 1'000'000}, {1, 16}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(firstFrameDeveloped)->Args({10'000, 1})->Unit(benchmark::kMillisecond)->UseRealTime();

/// A parameter moves, the camera rests.
void reshadeGl(benchmark::State& state)
{
    Pair pair(state.range(0), 1);
    alternate(
        state,
        [&] {
            pair.renderer.invalidateShading();
            pair.render(true);
        },
        [&] {
            pair.forward.drawFullScreen();
            pair.forward.finish();
        });
}
BENCHMARK(reshadeGl)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace reflectance::bench
