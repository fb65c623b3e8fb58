#include "core/study/trade/dial.h"

#include "core/base/text.h"
#include "core/study/trade/rung.h"
#include "core/study/trade/trade_run.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

constexpr int probeRepetitions = 3, repetitions = 7;
/// The probe's share of the progress.
constexpr double shareOfProbe = 0.4;
/// Of a budget: so many of the most exact on the probe are compared on the whole picture.
constexpr std::size_t finalists = 12;
/// The probe's costs, scaled by pixels, are this uncertain.
constexpr double slack = 1.5;

RenderSettings probeOf(const RenderSettings& settings, int side)
{
    const double scale = std::min(1.0, static_cast<double>(side) / std::max(settings.width, settings.height));
    const auto scaled = [&](int pixels) { return std::max(1, static_cast<int>(std::lround(pixels * scale))); };
    return {scaled(settings.width), scaled(settings.height), settings.samplesPerAxis};
}

/// Measures candidates on the whole picture, one by one, when asked.
class Verifier {
public:
    Verifier(const Scene& scene, const RenderSettings& settings, GlRenderer* gl, Progress* progress)
        : settings_(settings), workshop_(scene.mesh, scene.camera, gl),
          judge_(Workshop::truth(scene, settings, progress, 0.4), gainOf(scene.sensor))
    {
    }

    [[nodiscard]] const Judge& judge() const { return judge_; }

    /// The candidate of the probe with error and cost on the picture.
    [[nodiscard]] Result<Candidate> measured(const Candidate& onProbe, bool withTimes)
    {
        Recipe recipe = onProbe.recipe;
        recipe.settings.width = settings_.width;
        recipe.settings.height = settings_.height;
        const auto prepared = workshop_.prepare(recipe);
        if (!prepared)
            return prepared.error();
        const auto picture = workshop_.picture(*prepared);
        if (!picture)
            return picture.error();
        Candidate candidate = onProbe;
        candidate.recipe = recipe;
        candidate.error = judge_.errorOf(*picture);
        candidate.lookMilliseconds = prepared->lookMilliseconds;
        candidate.bytes = prepared->bytes;
        candidate.shadings = prepared->shadings;
        std::vector<double> times;
        for (int i = 0; withTimes && i < repetitions; ++i) {
            const auto time = workshop_.shadingTime(*prepared);
            if (!time)
                return time.error();
            times.push_back(*time);
        }
        candidate.shade = timingOf(times);
        return candidate;
    }

private:
    RenderSettings settings_;
    Workshop workshop_;
    Judge judge_;
};

using Order = std::vector<const Candidate*>;

template <class Measure> void sortBy(Order& order, const Measure& measure)
{
    std::stable_sort(order.begin(), order.end(),
                     [&](const Candidate* a, const Candidate* b) { return measure(*a) < measure(*b); });
}

Result<DialAnswer> withinTolerance(const Trade& probe, const DialWish& wish, Verifier& verifier, Progress* progress)
{
    const auto error = [&](const Candidate& c) { return c.error.by(wish.metric); };
    Order good, rest;
    for (const Candidate& candidate : probe.candidates)
        (error(candidate) <= *wish.tolerance ? good : rest).push_back(&candidate);
    sortBy(good, [&](const Candidate& c) { return c.cost(wish.cost); });
    sortBy(rest, error);
    const std::size_t approved = good.size();
    good.insert(good.end(), rest.begin(), rest.end());
    DialAnswer answer;
    for (std::size_t i = 0; i < good.size() && !(progress && progress->cancel); ++i) {
        auto candidate = verifier.measured(*good[i], false);
        if (!candidate)
            return candidate.error();
        ++answer.verified;
        const double found = error(*candidate);
        const bool holds = found <= *wish.tolerance;
        if (holds || !answer.best || found < error(*answer.best))
            answer.best = *candidate;
        if (holds) {
            auto timed = verifier.measured(*good[i], true);
            if (!timed)
                return timed.error();
            answer.chosen = *std::move(timed);
            return answer;
        }
        if (i < approved)
            answer.missed.push_back({nameOf(candidate->recipe), error(*good[i]), found});
    }
    return answer;
}

Result<DialAnswer> withinBudget(const Trade& probe, const DialWish& wish, double pixelRatio, Verifier& verifier,
                                Progress* progress)
{
    const auto error = [&](const Candidate& c) { return c.error.by(wish.metric); };
    Order affordable;
    for (const Candidate& candidate : probe.candidates)
        if (candidate.cost(wish.cost) * pixelRatio <= slack * *wish.milliseconds)
            affordable.push_back(&candidate);
    sortBy(affordable, error);
    if (affordable.size() > finalists)
        affordable.resize(finalists);
    if (affordable.empty())
        if (const Candidate* least = cheapest(probe))
            affordable.push_back(least);
    DialAnswer answer;
    for (const Candidate* onProbe : affordable) {
        if (progress && progress->cancel)
            break;
        auto candidate = verifier.measured(*onProbe, true);
        if (!candidate)
            return candidate.error();
        ++answer.verified;
        if (!answer.best || candidate->cost(wish.cost) < answer.best->cost(wish.cost))
            answer.best = *candidate;
        if (candidate->cost(wish.cost) <= *wish.milliseconds &&
            (!answer.chosen || error(*candidate) < error(*answer.chosen))) {
            if (answer.chosen) // it looked at least as good on the probe
                answer.missed.push_back({nameOf(answer.chosen->recipe), error(*onProbe), error(*answer.chosen)});
            answer.chosen = *std::move(candidate);
        }
    }
    return answer;
}

std::string inWords(const Candidate& candidate, const DialWish& wish)
{
    return nameOf(candidate.recipe) + ": " + std::string(labelOf(wish.metric)) + " " +
           general(candidate.error.by(wish.metric), 3) +
           (candidate.shade.repetitions > 0 ? ", " + general(candidate.cost(wish.cost), 3) + " ms" : "") + "; it " +
           givenUp(candidate.recipe);
}

} // namespace

Result<void> checkWish(const DialWish& wish)
{
    if (wish.tolerance.has_value() == wish.milliseconds.has_value())
        return Error{"the dial takes either a tolerance or a budget in milliseconds; give one of the two"};
    if (wish.tolerance && !(*wish.tolerance >= 0.0 && std::isfinite(*wish.tolerance)))
        return Error{"a tolerance of " + general(*wish.tolerance, 6) + " is no error; give 0 or a positive number"};
    if (wish.milliseconds && !(*wish.milliseconds > 0.0 && std::isfinite(*wish.milliseconds)))
        return Error{"nothing can be drawn in " + general(*wish.milliseconds, 6) +
                     " ms; give a budget above 0 milliseconds"};
    return {};
}

Result<DialAnswer> dialled(const Scene& scene, const RenderSettings& settings, const DialWish& wish, GlRenderer* gl,
                           Progress* progress)
{
    if (auto possible = checkWish(wish); !possible)
        return possible.error();
    const RenderSettings small = probeOf(settings, wish.probeSide);
    TradeOptions options;
    options.metric = wish.metric;
    options.cost = wish.cost;
    options.repetitions = probeRepetitions;
    const auto probe = measuredTrade(scene, small, options, gl, progress, shareOfProbe);
    if (!probe)
        return probe.error();
    Verifier verifier(scene, settings, gl, progress);
    if (progress && progress->cancel)
        return Error{"stopped; nothing was chosen"};
    const double ratio = static_cast<double>(Image::pixelCount(settings.width, settings.height)) /
                         static_cast<double>(Image::pixelCount(small.width, small.height));
    auto answer = wish.tolerance ? withinTolerance(*probe, wish, verifier, progress)
                                 : withinBudget(*probe, wish, ratio, verifier, progress);
    if (progress && progress->cancel)
        return Error{"stopped; nothing was chosen"};
    if (answer)
        answer->tried = probe->candidates.size();
    return answer;
}

std::optional<ErrorFigures> recheckedOn(const Scene& scene, const RenderSettings& settings, const Recipe& chosen,
                                        Progress* progress)
{
    Recipe recipe{scene, settings};
    for (const std::string& id : chosen.rungs) {
        const Rung* rung = findRung(id == "glsl" ? "simd" : id);
        if (id == "half_buffer")
            continue; // GL alone has it
        if (!rung || !applyRung(*rung, recipe).skipped.empty())
            return std::nullopt;
    }
    Workshop workshop(scene.mesh, scene.camera, nullptr);
    const Judge judge(Workshop::truth(scene, settings, progress), gainOf(scene.sensor));
    if (progress && progress->cancel)
        return std::nullopt;
    const auto prepared = workshop.prepare(recipe);
    if (!prepared)
        return std::nullopt;
    const auto picture = workshop.picture(*prepared);
    return picture ? std::optional(judge.errorOf(*picture)) : std::nullopt;
}

std::vector<std::string> sentencesOf(const DialAnswer& answer, const DialWish& wish)
{
    std::vector<std::string> sentences;
    if (answer.chosen)
        sentences.push_back("Chosen: " + inWords(*answer.chosen, wish) + ".");
    else if (answer.best)
        sentences.push_back(std::string("Nothing meets that; the ") + (wish.tolerance ? "most exact" : "cheapest") +
                            " that can be had is " + inWords(*answer.best, wish) + ".");
    sentences.push_back(std::to_string(answer.tried) + " ways were tried on a small probe, " +
                        std::to_string(answer.verified) + " verified on the whole picture.");
    for (const Missed& missed : answer.missed)
        sentences.push_back("The probe missed what " + missed.name + " loses: " + general(missed.onProbe, 3) +
                            " there, " + general(missed.onPicture, 3) + " on the whole picture.");
    return sentences;
}

} // namespace reflectance
