#include "core/study/price_tag.h"

#include "core/reflectance/kernel_tables.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/study/cost/timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// Fills in the error figures. A channel that is not finite in the picture alone is infinitely wrong.
void holdAgainst(const Image& truth, const Image& image, PriceTag& tag)
{
    double squares = 0.0;
    std::size_t covered = 0;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            if (!(truth.coverage[Image::pixelCount(truth.width, y) + static_cast<std::size_t>(x)] > 0.0F))
                continue;
            ++covered;
            for (int channel = 0; channel < 3; ++channel) {
                const double difference = double{image.at(x, y)[channel]} - double{truth.at(x, y)[channel]};
                const double error =
                    std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::fabs(difference);
                squares += error * error;
                if (error > tag.maxError) {
                    tag.maxError = error;
                    tag.worstX = x;
                    tag.worstY = y;
                }
            }
        }
    tag.rmse = covered > 0 ? std::sqrt(squares / (3.0 * static_cast<double>(covered))) : 0.0;
}

void measureCpu(const Scene& scene, const RenderSettings& settings, int repetitions, std::vector<PriceTag>& tags)
{
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh, settings), scene.camera, settings);
    Image truth;
    for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd}) {
        Image image;
        PriceTag& tag = tags.emplace_back();
        tag.name =
            precision == Precision::Simd ? std::string("simd (") + lanesName() + ")" : std::string(nameOf(precision));
        tag.milliseconds =
            timed(repetitions, byTheWall([&] { image = shadeSamples(samples, scene, precision); })).median;
        if (precision == Precision::Double)
            truth = std::move(image);
        else
            holdAgainst(truth, image, tag);
    }
}

void measureGl(const Scene& scene, const RenderSettings& settings, GlRenderer& gl, int repetitions,
               std::vector<PriceTag>& tags)
{
    if (!gl.render(scene, settings))
        return; // what GL cannot draw has no price; whoever shows the picture reports why
    PriceTag tag;
    tag.name = "gl";
    const auto draw = [&] {
        gl.invalidateShading();
        // The same scene has just been drawn.
        static_cast<void>(gl.render(scene, settings));
    };
    tag.milliseconds = timed(repetitions, [&] { return gl.millisecondsOf(draw); }).median;
    const Image image = gl.readLinear();
    holdAgainst(shadeSamples(gl.readSamples(), scene, Precision::Double), image, tag);
    tags.push_back(std::move(tag));
}

} // namespace

std::vector<PriceTag> priceTags(const Scene& scene, const RenderSettings& settings, GlRenderer* gl, int repetitions)
{
    std::vector<PriceTag> tags;
    measureCpu(scene, settings, repetitions, tags);
    if (gl != nullptr)
        measureGl(scene, settings, *gl, repetitions, tags);
    return tags;
}

} // namespace reflectance
