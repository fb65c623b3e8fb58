#include "app/cli/waterfall_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace reflectance::cli {

void printWaterfall(const Waterfall& waterfall)
{
    std::printf("%-10s %12s %12s %9s\n", "step", "rmse", "largest", "share");
    for (const WaterfallStep& step : waterfall.steps)
        std::printf("%-10s %12.4g %12.4g %8.2f%%\n", step.step.c_str(), step.rmse, step.maxAbs, 100.0 * step.share);
    std::printf("%-10s %12.4g %12.4g\n", "all", waterfall.rmse, waterfall.maxAbs);
    if (waterfall.leftOut > 0)
        std::printf("%zu channels are not finite and left out\n", waterfall.leftOut);
}

nlohmann::ordered_json waterfallReport(const Waterfall& waterfall)
{
    auto steps = nlohmann::ordered_json::array();
    for (const WaterfallStep& step : waterfall.steps)
        steps.push_back({{"step", step.step}, {"rmse", step.rmse}, {"max", step.maxAbs}, {"share", step.share}});
    return {{"steps", steps}, {"rmse", waterfall.rmse}, {"max", waterfall.maxAbs}, {"left_out", waterfall.leftOut}};
}

} // namespace reflectance::cli
