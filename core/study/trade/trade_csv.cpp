#include "core/base/text.h"
#include "core/study/trade/trade_chart.h"

namespace reflectance {
namespace {

std::string optionalNumber(const std::optional<double>& number)
{
    return number ? shortest(*number) : std::string();
}

} // namespace

std::string csvOf(const Trade& trade)
{
    std::string text =
        "candidate,front,max,rmse,relative,de_mean,de_p95,de_max,flip,change,bound,shade_ms,shade_spread_ms,"
        "look_ms,shadings,bytes,kernel_ns,kernel_instructions\n";
    for (const Candidate& c : trade.candidates) {
        const PerceivedDifference& seen = c.error.perceived;
        text += joined({nameOf(c.recipe), c.onFront ? "1" : "0", shortest(c.error.max), shortest(c.error.rmse),
                        shortest(c.error.relative), shortest(seen.deltaEMean), shortest(seen.deltaEP95),
                        shortest(seen.deltaEMax), shortest(seen.flipMean), shortest(c.change), optionalNumber(c.bound),
                        shortest(c.shade.median), shortest(c.shade.spread), shortest(c.lookMilliseconds),
                        std::to_string(c.shadings), std::to_string(c.bytes), optionalNumber(c.kernelNs),
                        optionalNumber(c.kernelInstructions)},
                       ",") +
                "\n";
    }
    return text;
}

} // namespace reflectance
