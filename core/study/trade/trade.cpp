#include "core/study/trade/trade.h"

#include "core/base/text.h"
#include "core/study/trade/rung.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace reflectance {
namespace {

/// What is to be small, and what decides between equals.
using Measure = std::function<std::pair<double, double>(const Candidate&)>;

Measure costThenError(const Trade& trade)
{
    return [&trade](const Candidate& c) { return std::pair(c.cost(trade.cost), c.error.by(trade.metric)); };
}

Measure errorThenCost(const Trade& trade)
{
    return [&trade](const Candidate& c) { return std::pair(c.error.by(trade.metric), c.cost(trade.cost)); };
}

/// The candidate with the smallest measure among those that pass; nothing where none does.
std::optional<std::size_t> smallest(const Trade& trade, const Measure& measure,
                                    const std::function<bool(const Candidate&)>& passes)
{
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < trade.candidates.size(); ++i)
        if (passes(trade.candidates[i]) && (!best || measure(trade.candidates[i]) < measure(trade.candidates[*best])))
            best = i;
    return best;
}

const Candidate* at(const Trade& trade, const std::optional<std::size_t>& index)
{
    return index ? &trade.candidates[*index] : nullptr;
}

bool everything(const Candidate& /*candidate*/)
{
    return true;
}

bool dominates(const Trade& trade, const Candidate& a, const Candidate& b)
{
    const double errorA = a.error.by(trade.metric), errorB = b.error.by(trade.metric);
    const double costA = a.cost(trade.cost), costB = b.cost(trade.cost);
    return errorA <= errorB && costA <= costB && (errorA < errorB || costA < costB);
}

} // namespace

std::string_view labelOf(Cost cost)
{
    return cost == Cost::Shading ? "ms to shade again" : "ms to the first picture of a view";
}

double Candidate::cost(Cost which) const
{
    return which == Cost::Shading ? shade.median : shade.median + lookMilliseconds;
}

void markFront(Trade& trade)
{
    for (Candidate& candidate : trade.candidates)
        candidate.onFront = std::none_of(trade.candidates.begin(), trade.candidates.end(),
                                         [&](const Candidate& other) { return dominates(trade, other, candidate); });
}

std::vector<std::size_t> frontOf(const Trade& trade)
{
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < trade.candidates.size(); ++i)
        if (trade.candidates[i].onFront)
            front.push_back(i);
    std::stable_sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
        return trade.candidates[a].error.by(trade.metric) > trade.candidates[b].error.by(trade.metric);
    });
    return front;
}

std::vector<std::string> dominatedRungs(const Trade& trade)
{
    std::vector<std::string> dominated;
    for (const Rung& rung : rungs()) {
        bool tried = false;
        bool survives = false;
        for (const Candidate& candidate : trade.candidates) {
            const auto& taken = candidate.recipe.rungs;
            if (std::find(taken.begin(), taken.end(), rung.id) == taken.end())
                continue;
            tried = true;
            survives = survives || candidate.onFront;
        }
        if (tried && !survives)
            dominated.emplace_back(rung.id);
    }
    return dominated;
}

std::optional<std::size_t> cheapestWithin(const Trade& trade, double tolerance)
{
    return smallest(trade, costThenError(trade),
                    [&](const Candidate& c) { return c.error.by(trade.metric) <= tolerance; });
}

std::optional<std::size_t> bestWithin(const Trade& trade, double milliseconds)
{
    return smallest(trade, errorThenCost(trade),
                    [&](const Candidate& c) { return c.cost(trade.cost) <= milliseconds; });
}

std::optional<std::size_t> chosen(const Trade& trade, const Wanted& wanted)
{
    return wanted.tolerance      ? cheapestWithin(trade, *wanted.tolerance)
           : wanted.milliseconds ? bestWithin(trade, *wanted.milliseconds)
                                 : std::nullopt;
}

const Candidate* mostExact(const Trade& trade)
{
    return at(trade, smallest(trade, errorThenCost(trade), everything));
}

const Candidate* cheapest(const Trade& trade)
{
    return at(trade, smallest(trade, costThenError(trade), everything));
}

std::string givenUp(const Recipe& recipe)
{
    std::vector<std::string> what;
    for (const std::string& id : recipe.rungs)
        if (const Rung* rung = findRung(id); rung && id != "double")
            what.emplace_back(rung->about);
    if (what.empty())
        return "gives up nothing";
    if (what.size() == 1)
        return "gives up " + what[0];
    const std::string last = what.back();
    what.pop_back();
    return "gives up " + joined(what) + " and " + last;
}

} // namespace reflectance
