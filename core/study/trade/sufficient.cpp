#include "core/study/trade/sufficient.h"

#include "core/image/colour_difference.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/scene/requirements.h"
#include "core/study/cost/shading_cost.h"
#include "core/study/trade/rung.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reflectance {
namespace {

constexpr std::array<std::uint8_t, 3> behind{24, 26, 30};

/// The scene's surface, and what rungs of model and K make of it, alone and together.
std::vector<Recipe> simplerSurfaces(const Scene& scene, const RenderSettings& settings)
{
    std::vector<Recipe> found{Recipe{scene, settings}};
    for (const RungAxis axis : {RungAxis::Model, RungAxis::Matrix}) {
        const std::vector<Recipe> before = found;
        for (const Recipe& start : before)
            for (const Rung& rung : rungs()) {
                Recipe recipe = start;
                if (rung.axis == axis && applyRung(rung, recipe).skipped.empty())
                    found.push_back(std::move(recipe));
            }
    }
    return found;
}

/// How far each pixel of a picture is from the whole surface's.
class PixelErrors {
public:
    PixelErrors(const Image& whole, Metric metric, double gain)
        : whole_(whole), metric_(metric), factor_(static_cast<float>(gain))
    {
    }

    [[nodiscard]] double at(const Image& picture, std::size_t pixel) const
    {
        const float* a = &whole_.rgb[3 * pixel];
        const float* b = &picture.rgb[3 * pixel];
        if (metric_ == Metric::DeltaE) {
            const float one[] = {factor_ * a[0], factor_ * a[1], factor_ * a[2]};
            const float other[] = {factor_ * b[0], factor_ * b[1], factor_ * b[2]};
            return deltaE2000(labOfDisplayed(one), labOfDisplayed(other));
        }
        double largest = 0.0, squares = 0.0;
        for (int channel = 0; channel < 3; ++channel) {
            const double difference = static_cast<double>(b[channel]) - static_cast<double>(a[channel]);
            const double size = std::isnan(difference) ? HUGE_VAL : std::fabs(difference);
            largest = std::max(largest, size);
            squares += size * size;
        }
        return metric_ == Metric::Max ? largest : std::sqrt(squares / 3.0);
    }

private:
    const Image& whole_;
    Metric metric_;
    float factor_;
};

double kernelCost(const Scene& scene)
{
    return shadingCost(requiredSurface(scene), Precision::Simd);
}

/// Whether a model has all the rungs of another and more, and yet saves less than a tenth: noise decides such pairs, and the
/// more exact one shall win them.
bool savesNothingOver(const SufficientModel& fuller, const SufficientModel& model)
{
    const auto& has = model.recipe.rungs;
    return has.size() > fuller.recipe.rungs.size() && model.nanoseconds > 0.9 * fuller.nanoseconds &&
           std::ranges::all_of(fuller.recipe.rungs, [&](const std::string& rung) {
               return std::find(has.begin(), has.end(), rung) != has.end();
           });
}

/// Simpler surfaces by rising cost, those that save nothing over a more exact one left out, and the whole one last.
std::vector<SufficientModel> ladderOf(const Scene& scene, const RenderSettings& settings)
{
    std::vector<SufficientModel> models;
    for (Recipe& recipe : simplerSurfaces(scene, settings)) {
        const double cost = kernelCost(recipe.scene);
        models.push_back({std::move(recipe), cost, 0, 0});
    }
    const std::vector<SufficientModel> all = models;
    std::erase_if(models, [&](const SufficientModel& m) {
        return m.recipe.rungs.empty() ||
               std::ranges::any_of(all, [&](const SufficientModel& fuller) { return savesNothingOver(fuller, m); });
    });
    std::stable_sort(models.begin(), models.end(),
                     [](const SufficientModel& a, const SufficientModel& b) { return a.nanoseconds < b.nanoseconds; });
    models.push_back(all.front());
    for (std::size_t i = 0; i < models.size(); ++i)
        models[i].color = seriesColor(i);
    return models;
}

} // namespace

std::optional<SufficientMap> sufficientModels(const Scene& scene, const RenderSettings& settings, double tolerance,
                                              Metric metric, Progress* progress)
{
    const auto stopped = [&] { return progress != nullptr && progress->cancel; };
    SufficientMap map;
    map.width = settings.width;
    map.height = settings.height;
    map.models = ladderOf(scene, settings);
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh, settings), scene.camera, settings);
    if (stopped())
        return std::nullopt;
    const Image whole = shadeSamples(samples, scene, Precision::Double);
    const PixelErrors errors(whole, metric, gainOf(scene.sensor));
    const auto last = static_cast<std::uint8_t>(map.models.size() - 1);
    map.modelOf.assign(whole.pixels(), SufficientMap::background);
    for (std::size_t pixel = 0; pixel < whole.pixels(); ++pixel)
        if (whole.coverage[pixel] > 0.0F)
            map.modelOf[pixel] = last;
    for (std::size_t i = 0; i < last; ++i) {
        const Image picture = shadeSamples(samples, map.models[i].recipe.scene, Precision::Double);
        if (stopped())
            return std::nullopt;
        for (std::size_t pixel = 0; pixel < whole.pixels(); ++pixel)
            if (map.modelOf[pixel] == last && errors.at(picture, pixel) <= tolerance)
                map.modelOf[pixel] = static_cast<std::uint8_t>(i);
        if (progress != nullptr)
            progress->done = static_cast<double>(i + 1) / last;
    }
    for (const std::uint8_t model : map.modelOf)
        if (model != SufficientMap::background)
            ++map.models[model].pixels;
    return map;
}

std::vector<std::uint8_t> painted(const SufficientMap& map)
{
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * map.modelOf.size());
    for (const std::uint8_t model : map.modelOf) {
        if (model == SufficientMap::background) {
            rgb.insert(rgb.end(), behind.begin(), behind.end());
            continue;
        }
        const ChartColor color = map.models[model].color;
        for (const int shift : {16, 8, 0})
            rgb.push_back(static_cast<std::uint8_t>(color >> shift & 0xFFU));
    }
    return rgb;
}

} // namespace reflectance
