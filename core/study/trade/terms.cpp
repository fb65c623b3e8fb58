#include "core/study/trade/terms.h"

#include "core/render/cpu/cpu_renderer.h"
#include "core/study/trade/rung.h"

namespace reflectance {
namespace {

/// What is left where a rung was taken; nothing where it does not apply.
std::optional<Scene> without(const char* rung, const Scene& scene)
{
    Recipe recipe{scene, {}};
    if (!applyRung(*findRung(rung), recipe).skipped.empty())
        return std::nullopt;
    return recipe.scene;
}

void addSurfaceTerms(const Scene& scene, std::vector<Term>& terms)
{
    if (modelOf(scene).id() == "hybrid") {
        Scene specular = scene;
        specular.surface.model = "phong";
        terms.push_back({"diffuse", specular});
    }
    constexpr std::pair<const char*, const char*> rungOfTerm[] = {{"specular", "no_highlight"},
                                                                  {"off-diagonal K", "k_diagonal"},
                                                                  {"colour of K", "k_grey"},
                                                                  {"interreflection", "oren_nayar"},
                                                                  {"roughness", "lambert"}};
    for (const auto& [name, rung] : rungOfTerm)
        if (auto rest = without(rung, scene))
            terms.push_back({name, *std::move(rest)});
}

} // namespace

std::vector<Term> termsOf(const Scene& scene)
{
    std::vector<Term> terms;
    addSurfaceTerms(scene, terms);
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].on) {
            Scene dark = scene;
            dark.lights[i].on = false;
            terms.push_back({"light '" + scene.lights[i].name + "'", std::move(dark)});
        }
    if (modelOf(scene).text.usesEnvironment && scene.environment.kind != EnvironmentKind::None) {
        Scene alone = scene;
        alone.environment.kind = EnvironmentKind::None;
        terms.push_back({"surroundings", std::move(alone)});
    }
    return terms;
}

std::optional<TermBars> termBars(const Scene& scene, const RenderSettings& settings, int repetitions,
                                 Progress* progress)
{
    const auto stopped = [&] { return progress != nullptr && progress->cancel; };
    const std::vector<Term> terms = termsOf(scene);
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh, settings), scene.camera, settings);
    const Judge judge(shadeSamples(samples, scene, Precision::Double), gainOf(scene.sensor));
    TermBars bars;
    for (const Term& term : terms) {
        if (stopped())
            return std::nullopt;
        bars.terms.push_back(
            {term.name, judge.errorOf(shadeSamples(samples, term.without, Precision::Double)), 0.0, 0.0});
    }
    std::vector<double> whole;
    std::vector<std::vector<double>> saved(terms.size());
    const auto shadingOf = [&](const Scene& shaded) {
        return millisecondsOf([&] { static_cast<void>(shadeSamples(samples, shaded, Precision::Simd)); });
    };
    for (int round = 0; round <= repetitions; ++round) { // the first warms up
        for (std::size_t i = 0; i < terms.size() && !stopped(); ++i) {
            const double withAll = shadingOf(scene); // neighbours in time, so that a slow moment slows both
            const double withoutTerm = shadingOf(terms[i].without);
            if (round == 0)
                continue;
            whole.push_back(withAll);
            saved[i].push_back(withAll - withoutTerm);
        }
        if (progress != nullptr)
            progress->done = (round + 1.0) / (repetitions + 1.0);
    }
    if (stopped())
        return std::nullopt;
    bars.whole = timingOf(whole);
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const Timing timing = timingOf(saved[i]);
        bars.terms[i].milliseconds = timing.median;
        bars.terms[i].spread = timing.spread;
    }
    return bars;
}

} // namespace reflectance
