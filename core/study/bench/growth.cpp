#include "core/study/bench/growth.h"

#include "core/base/text.h"
#include "core/measured/resample.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/study/bench/ball.h"
#include "core/study/bench/direction_rows.h"
#include "core/study/bench/interleaved.h"
#include "core/study/tables/sample_model.h"

#include <cmath>

namespace reflectance {
namespace {

constexpr int kinds = 5; ///< of growth, for the progress

Scene ballScene(std::size_t triangles, std::size_t lights)
{
    Scene scene;
    scene.mesh = ball(triangles);
    scene.meshFile = "sphere";
    scene.camera = framed(scene.camera, 1.0);
    for (std::size_t i = 0; i < lights; ++i) {
        Light& light = scene.lights.emplace_back();
        const double turn = static_cast<double>(i);
        light.direction = normalized({std::sin(turn), 0.5, 1.0 + std::cos(turn)});
        light.intensity = Vec3d(1.0 / static_cast<double>(lights));
    }
    return scene;
}

/// Measures one kind of growth: works are made for each size, and all sizes are timed in turns.
class Measuring {
public:
    Measuring(GlRenderer* gl, int repetitions, Progress& progress)
        : gl_(gl), repetitions_(repetitions), progress_(progress)
    {
    }

    /// Shading again, in lanes and in GL.
    void shading(const std::string& with, const std::vector<double>& sizes, const std::vector<Scene>& scenes,
                 const std::vector<RenderSettings>& settings)
    {
        std::vector<ViewSamples> samples;
        for (std::size_t i = 0; i < sizes.size(); ++i)
            samples.push_back(sampleView(*makeRayScene(scenes[i].mesh), scenes[i].camera, settings[i]));
        std::vector<TimedWork> works;
        for (std::size_t i = 0; i < sizes.size(); ++i)
            works.emplace_back(
                byTheWall([&, i] { static_cast<void>(shadeSamples(samples[i], scenes[i], Precision::Simd)); }));
        run(with, "shading, simd", sizes, works, gl_ != nullptr ? 0.5 : 1.0);
        for (std::size_t i = 0; gl_ != nullptr && i < sizes.size(); ++i) {
            // One renderer keeps the samples of one size: the sizes follow each other.
            const auto draw = [&, i] {
                gl_->invalidateShading();
                note(gl_->render(scenes[i], settings[i]));
            };
            append(with, "shading, glsl", sizes[i], timed(repetitions_, [&] { return gl_->millisecondsOf(draw); }));
            progress_.done.fetch_add(0.5 / kinds / static_cast<double>(sizes.size()));
        }
    }

    /// From a mesh in memory to a picture: what depends on triangles.
    void firstFrames(const std::vector<double>& sizes, const RenderSettings& settings)
    {
        std::vector<Scene> scenes;
        for (const double size : sizes)
            scenes.push_back(ballScene(static_cast<std::size_t>(size), 1));
        std::vector<TimedWork> works;
        for (const Scene& scene : scenes)
            works.emplace_back(byTheWall([&] { static_cast<void>(renderOnCpu(scene, settings, Precision::Simd)); }));
        run("triangles", "first frame, simd", sizes, works, gl_ != nullptr ? 0.5 : 1.0);
        works.clear();
        for (Scene& scene : scenes)
            works.push_back(byTheWall([&] { // another mesh each time, so that it is uploaded anew: the way there counts
                note(gl_->render(scene, settings));
                gl_->finish();
            }));
        if (gl_ != nullptr)
            run("triangles", "first frame, glsl", sizes, works, 0.5);
    }

    /// Looking a measured table up: what depends on its size is the memory it comes from.
    void tables(const std::vector<double>& thetas, std::size_t rows)
    {
        const Model& phong = **findModel("phong");
        const Model& model = **findModel("table");
        DirectionRows<float> directions(rows);
        std::vector<std::shared_ptr<const MeasuredTable>> all;
        std::vector<double> sizes;
        for (const double count : thetas) {
            const auto steps = static_cast<std::size_t>(count);
            const BrdfFunction f = brdfOf(phong, flatValues(phong.text, {}), 3);
            all.push_back(measuredTable(sampled(isotropicShape(steps, steps), 3, f)));
            sizes.push_back(static_cast<double>(all.back()->table.samples()));
        }
        std::vector<TimedWork> works;
        for (const auto& table : all)
            works.emplace_back(
                byTheWall([&] { model.lanes.shade(nullptr, directions.batch(lookUpsIn(table.get()).single)); }));
        run("table samples", "a batch, simd", sizes, works, 1.0);
    }

    Result<std::vector<Growth>> taken()
    {
        if (!drawn_)
            return drawn_.error();
        return std::move(growths_);
    }

private:
    void note(Result<void> drawn)
    {
        if (!drawn)
            drawn_ = std::move(drawn);
    }
    void append(const std::string& with, const std::string& cost, double size, const Timing& timing)
    {
        if (growths_.empty() || growths_.back().with != with || growths_.back().cost != cost)
            growths_.push_back({with, cost, {}, {}});
        growths_.back().sizes.push_back(size);
        growths_.back().milliseconds.push_back(timing);
    }
    void run(const std::string& with, const std::string& cost, const std::vector<double>& sizes,
             const std::vector<TimedWork>& works, double share)
    {
        const auto timings = interleaved(works, repetitions_, 1.0, progress_, share / kinds);
        for (std::size_t i = 0; i < timings.size(); ++i)
            append(with, cost, sizes[i], timings[i]);
    }

    GlRenderer* gl_;
    int repetitions_;
    Progress& progress_;
    Result<void> drawn_;
    std::vector<Growth> growths_;
};

} // namespace

double Growth::exponent() const
{
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    const auto count = static_cast<double>(sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double size = std::log(sizes[i]);
        const double time = std::log(milliseconds[i].median);
        x += size / count;
        y += time / count;
        xx += size * size / count;
        xy += size * time / count;
    }
    return (xy - x * y) / (xx - x * x);
}

Result<std::vector<Growth>> growths(GlRenderer* gl, bool quick, Progress& progress)
{
    Measuring measuring(gl, quick ? 3 : 7, progress);
    const int side = quick ? 128 : 512;
    const std::size_t triangles = quick ? 1000 : 20'000;
    measuring.firstFrames(quick ? std::vector<double>{1e3, 4e3, 16e3} : std::vector<double>{1e4, 4e4, 16e4, 64e4},
                          {side, side, 1});
    std::vector<double> sizes;
    std::vector<Scene> scenes;
    std::vector<RenderSettings> settings;
    const auto grow = [&](double size, std::size_t lights, const RenderSettings& s) {
        sizes.push_back(size);
        scenes.push_back(ballScene(triangles, lights));
        settings.push_back(s);
    };
    const auto shade = [&](const std::string& with) {
        measuring.shading(with, sizes, scenes, settings);
        sizes.clear();
        scenes.clear();
        settings.clear();
    };
    for (int s = side / 4; s <= 2 * side; s *= 2)
        grow(static_cast<double>(s) * s, 1, {s, s, 1});
    shade("pixels");
    for (const std::size_t lights : {1U, 4U, 16U, 64U})
        grow(static_cast<double>(lights), lights, {side, side, 1});
    shade("lights");
    for (int k = 1; k <= 4; ++k)
        grow(k * k, 1, {side, side, k});
    shade("samples");
    measuring.tables(quick ? std::vector<double>{8, 16, 24} : std::vector<double>{12, 24, 48, 96},
                     std::size_t{1} << (quick ? 12U : 17U));
    return measuring.taken();
}

Chart chartOf(const std::vector<Growth>& growths)
{
    Chart chart;
    chart.title = "Cost against size";
    std::vector<double> allX;
    std::vector<double> allY;
    for (std::size_t i = 0; i < growths.size(); ++i) {
        const Growth& growth = growths[i];
        Series series;
        series.name = growth.with + ": " + growth.cost + ", exponent " + general(growth.exponent(), 2);
        series.color = seriesColor(i);
        series.mark = Mark::LineAndDots;
        series.dashed = growth.cost.find("glsl") != std::string::npos;
        for (std::size_t p = 0; p < growth.sizes.size(); ++p) {
            series.x.push_back(growth.sizes[p] / growth.sizes[0]);
            series.y.push_back(growth.milliseconds[p].median / growth.milliseconds[0].median);
            series.spread.push_back(growth.milliseconds[p].spread / growth.milliseconds[0].median);
        }
        allX.insert(allX.end(), series.x.begin(), series.x.end());
        allY.insert(allY.end(), series.y.begin(), series.y.end());
        chart.series.push_back(std::move(series));
    }
    chart.x = axisAround("size, as a multiple of the smallest", allX, AxisScale::Log);
    chart.y = axisAround("time, as a multiple of the smallest size's", allY, AxisScale::Log);
    return chart;
}

} // namespace reflectance
