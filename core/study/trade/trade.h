// What was measured: recipes with their error and cost on one scene, and which of them are worth having.
#pragma once

#include "core/study/cost/machine.h"
#include "core/study/cost/timing.h"
#include "core/study/trade/judge.h"
#include "core/study/trade/recipe.h"
#include "core/study/trade/rung.h"

#include <optional>
#include <vector>

namespace reflectance {

/// Which cost is traded: of shading again what is seen (a drag of light or slider), or of the first picture of a view.
enum class Cost { Shading, FirstFrame };

[[nodiscard]] constexpr std::string_view nameOf(Cost cost)
{
    constexpr std::string_view names[] = {"shading", "frame"};
    return names[static_cast<int>(cost)];
}

/// "ms to shade again".
[[nodiscard]] std::string_view labelOf(Cost cost);

struct Candidate {
    Recipe recipe;
    ErrorFigures error;
    double change = 0.0;     ///< largest linear difference to its renderer's picture without rungs
    double changeRmse = 0.0; ///< the same as root mean square
    std::optional<double>
        bound;    ///< what its rungs promise `change` to be at most, where each of them promises something
    Timing shade; ///< ms to shade again
    double lookMilliseconds = 0.0;
    std::size_t shadings = 0;                 ///< evaluations of the model per light; 0 on GL, which does not say
    std::size_t bytes = 0;                    ///< kept between two shadings
    std::optional<double> kernelNs;           ///< per evaluation and light, warm; CPU only
    std::optional<double> kernelInstructions; ///< the same in machine instructions, where the system counts them
    bool onFront = false;

    [[nodiscard]] double cost(Cost which) const; ///< ms
};

struct Trade {
    std::string model, mesh;
    std::size_t triangles = 0, lights = 0;
    RenderSettings settings;
    Machine machine;
    Metric metric = Metric::Max;
    Cost cost = Cost::Shading;
    std::vector<Candidate> candidates;
    std::vector<SkippedRung> skipped;
    std::optional<std::size_t> current; ///< the candidate that is what the program would draw by itself
};

/// Marks the candidates that no other one is at once no dearer and no less exact than, and better in one of the two.
void markFront(Trade& trade);

/// The marked ones by falling error.
[[nodiscard]] std::vector<std::size_t> frontOf(const Trade& trade);

/// Rungs that were tried and are part of no candidate on the front: a finding in itself.
[[nodiscard]] std::vector<std::string> dominatedRungs(const Trade& trade);

/// The cheapest within the tolerance, and the most exact within so many milliseconds; nothing where none is.
[[nodiscard]] std::optional<std::size_t> cheapestWithin(const Trade& trade, double tolerance);
[[nodiscard]] std::optional<std::size_t> bestWithin(const Trade& trade, double milliseconds);

/// What a user asks of a trade: an error that is good enough, or the time there is.
struct Wanted {
    std::optional<double> tolerance = {}, milliseconds = {};

    [[nodiscard]] bool anything() const { return tolerance || milliseconds; }
};

/// The candidate that meets it; nothing where none does, or nothing is asked.
[[nodiscard]] std::optional<std::size_t> chosen(const Trade& trade, const Wanted& wanted);

/// The smallest error and the smallest cost of all.
[[nodiscard]] const Candidate* mostExact(const Trade& trade);
[[nodiscard]] const Candidate* cheapest(const Trade& trade);

/// "gives up the specular term and smooth edges": what its rungs say; "gives up nothing".
[[nodiscard]] std::string givenUp(const Recipe& recipe);

} // namespace reflectance
