#include "app/cli/trade_report.h"

#include "core/study/trade/rung.h"
#include "core/study/trade/trade_page.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& number)
{
    return number ? Json(*number) : Json(nullptr);
}

Json described(const ErrorFigures& error)
{
    return {{"max", error.max},
            {"rmse", error.rmse},
            {"relative", error.relative},
            {"de_mean", error.perceived.deltaEMean},
            {"de_p95", error.perceived.deltaEP95},
            {"de_max", error.perceived.deltaEMax},
            {"flip", error.perceived.flipMean}};
}

Json described(const Machine& machine)
{
    return {{"processor", machine.processor},
            {"cores", machine.cores},
            {"lanes", machine.lanes},
            {"compiler", machine.compiler},
            {"gl", machine.gl}};
}

Json nameAt(const Trade& trade, const std::optional<std::size_t>& index)
{
    return index ? Json(nameOf(trade.candidates[*index].recipe)) : Json(nullptr);
}

} // namespace

Json described(const Candidate& candidate)
{
    return {{"name", nameOf(candidate.recipe)},
            {"rungs", candidate.recipe.rungs},
            {"gives_up", givenUp(candidate.recipe)},
            {"front", candidate.onFront},
            {"error", described(candidate.error)},
            {"change", candidate.change},
            {"promised_change", orNull(candidate.bound)},
            {"shade_ms", candidate.shade.median},
            {"shade_ms_spread", candidate.shade.spread},
            {"repetitions", candidate.shade.repetitions},
            {"first_frame_ms", candidate.cost(Cost::FirstFrame)},
            {"shadings_per_light", candidate.shadings},
            {"bytes", candidate.bytes},
            {"ns_per_shading", orNull(candidate.kernelNs)},
            {"instructions_per_shading", orNull(candidate.kernelInstructions)}};
}

void print(const Trade& trade, const Wanted& wanted)
{
    std::printf("%-12s %10s %10s %10s %10s %9s  %s\n", std::string(nameOf(trade.metric)).c_str(), "ms again", "+-",
                "ms first", "MB kept", "ns", "worth having");
    for (const std::size_t i : frontOf(trade)) {
        const Candidate& c = trade.candidates[i];
        std::printf("%-12.4g %10.4g %10.2g %10.4g %10.3g %9.3g  %s\n", c.error.by(trade.metric), c.shade.median,
                    c.shade.spread, c.cost(Cost::FirstFrame), static_cast<double>(c.bytes) / 1e6,
                    c.kernelNs.value_or(0.0), nameOf(c.recipe).c_str());
    }
    std::printf("\n");
    for (const std::string& finding : findingsOf(trade, wanted))
        std::printf("%s\n", finding.c_str());
    for (const SkippedRung& skipped : trade.skipped)
        std::printf("skipped %s: %s\n", skipped.rung.c_str(), skipped.why.c_str());
    std::printf("on %s\n", sentenceOf(trade.machine).c_str());
}

Json described(const Trade& trade, const Wanted& wanted)
{
    Json candidates = Json::array();
    for (const Candidate& candidate : trade.candidates)
        candidates.push_back(described(candidate));
    Json skipped = Json::array();
    for (const SkippedRung& rung : trade.skipped)
        skipped.push_back({{"rung", rung.rung}, {"why", rung.why}});
    Json front = Json::array();
    for (const std::size_t i : frontOf(trade))
        front.push_back(nameOf(trade.candidates[i].recipe));
    return {{"model", trade.model},
            {"triangles", trade.triangles},
            {"lights", trade.lights},
            {"width", trade.settings.width},
            {"height", trade.settings.height},
            {"samples", trade.settings.samplesPerAxis * trade.settings.samplesPerAxis},
            {"metric", nameOf(trade.metric)},
            {"cost", nameOf(trade.cost)},
            {"machine", described(trade.machine)},
            {"tolerance", orNull(wanted.tolerance)},
            {"budget_ms", orNull(wanted.milliseconds)},
            {"chosen", nameAt(trade, chosen(trade, wanted))},
            {"drawn_now", nameAt(trade, trade.current)},
            {"front", front},
            {"never_worth_having", dominatedRungs(trade)},
            {"skipped", skipped},
            {"candidates", candidates}};
}

} // namespace reflectance::cli
