#include "core/study/trade/compose.h"

#include "core/study/trade/rung.h"

#include <algorithm>
#include <map>
#include <set>

namespace reflectance {
namespace {

/// The arithmetics in which other rungs are tried: the fastest of each renderer.
bool isBase(const Recipe& recipe)
{
    return recipe.rungs.size() == 1 && (recipe.rungs[0] == "simd" || recipe.rungs[0] == "glsl");
}

/// The rung that a single recipe adds to its base; null for a bare one.
const Rung* ownRung(const Recipe& recipe)
{
    return recipe.rungs.size() == 2 ? findRung(recipe.rungs[1]) : nullptr;
}

double changeOf(const Candidate& candidate, Metric metric)
{
    return metric == Metric::Max ? candidate.change : candidate.changeRmse;
}

struct Ladder {
    const Recipe* base = nullptr;
    double baseCost = 0.0;
    std::vector<const Candidate*> singles;
};

/// Of every axis the cheapest rung within the level; one that costs no less than going without stays away. The general path
/// computes the same and more, so that only noise could choose it: it is timed alone, for comparison.
std::map<RungAxis, const Candidate*> cheapestOfAxes(const Ladder& ladder, double level, Metric metric, Cost cost)
{
    std::map<RungAxis, const Candidate*> chosen;
    for (const Candidate* single : ladder.singles) {
        const RungAxis axis = ownRung(single->recipe)->axis;
        if (axis == RungAxis::Samples || axis == RungAxis::Requirements || changeOf(*single, metric) > level ||
            single->cost(cost) >= ladder.baseCost)
            continue;
        const Candidate*& best = chosen[axis];
        if (!best || single->cost(cost) < best->cost(cost))
            best = single;
    }
    return chosen;
}

std::vector<Ladder> laddersOf(const std::vector<Recipe>& bare, const std::vector<Candidate>& singles, Cost cost)
{
    std::vector<Ladder> ladders;
    for (const Recipe& base : bare) {
        if (!isBase(base))
            continue;
        Ladder ladder;
        ladder.base = &base;
        for (const Candidate& candidate : singles) {
            if (candidate.recipe.rungs == base.rungs)
                ladder.baseCost = candidate.cost(cost);
            else if (ownRung(candidate.recipe) && candidate.recipe.rungs[0] == base.rungs[0])
                ladder.singles.push_back(&candidate);
        }
        ladders.push_back(std::move(ladder));
    }
    return ladders;
}

/// Changes that differ by little suggest the same combinations: each level is at least three times the one before.
std::vector<double> levelsOf(const Ladder& ladder, Metric metric)
{
    std::set<double> changes;
    for (const Candidate* single : ladder.singles)
        changes.insert(changeOf(*single, metric));
    std::vector<double> levels;
    for (const double change : changes)
        if (levels.empty() || change >= 3.0 * levels.back())
            levels.push_back(change);
    return levels;
}

/// The base with the samples rung (or none) and one rung per axis; nothing where a rung no longer applies.
std::optional<Recipe> composed(const Recipe& base, const Rung* samples,
                               const std::map<RungAxis, const Candidate*>& chosen)
{
    Recipe recipe = base;
    if (samples && !applyRung(*samples, recipe).skipped.empty())
        return std::nullopt;
    for (const auto& [axis, candidate] : chosen)
        static_cast<void>(applyRung(*ownRung(candidate->recipe), recipe)); // what no longer applies stays away
    return recipe;
}

} // namespace

std::vector<Recipe> bareRecipes(const Scene& scene, const RenderSettings& settings, bool withGl)
{
    std::vector<Recipe> bare;
    const auto add = [&](std::initializer_list<const char*> ids) {
        Recipe recipe{scene, settings};
        for (const char* id : ids)
            static_cast<void>(applyRung(*findRung(id), recipe));
        bare.push_back(std::move(recipe));
    };
    add({"simd"});
    add({"float"});
    add({"double"});
    if (withGl) {
        add({"glsl"});
        add({"glsl", "half_buffer"});
    }
    return bare;
}

Singles singleRungs(const std::vector<Recipe>& bare)
{
    Singles singles;
    for (const Rung& rung : rungs()) {
        if (rung.axis == RungAxis::Precision)
            continue;
        bool applies = false;
        std::string why;
        for (const Recipe& base : bare) {
            if (!isBase(base) || !(base.onGl() ? rung.onGl : rung.onCpu))
                continue;
            Recipe recipe = base;
            const Applied applied = applyRung(rung, recipe);
            why = applied.skipped;
            if (!why.empty())
                continue;
            applies = true;
            singles.recipes.push_back(std::move(recipe));
            singles.bounds.push_back(applied.bound);
        }
        if (!applies)
            singles.skipped.push_back({rung.id, why});
    }
    return singles;
}

std::vector<Recipe> compositions(const std::vector<Recipe>& bare, const std::vector<Candidate>& singles, Metric metric,
                                 Cost cost)
{
    std::vector<Recipe> recipes;
    std::set<std::vector<std::string>> known;
    for (const Candidate& candidate : singles)
        known.insert(candidate.recipe.rungs);
    for (const Ladder& ladder : laddersOf(bare, singles, cost)) {
        std::vector<const Rung*> samples{nullptr};
        for (const Candidate* single : ladder.singles)
            if (const Rung* rung = ownRung(single->recipe); rung->axis == RungAxis::Samples)
                samples.push_back(rung);
        for (const Rung* count : samples)
            for (const double level : levelsOf(ladder, metric)) {
                auto recipe = composed(*ladder.base, count, cheapestOfAxes(ladder, level, metric, cost));
                if (recipe && known.insert(recipe->rungs).second)
                    recipes.push_back(*std::move(recipe));
            }
    }
    return recipes;
}

} // namespace reflectance
