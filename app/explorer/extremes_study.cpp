#include "app/explorer/extremes_study.h"

#include <algorithm>

namespace reflectance::explorer {

void ExtremesStudy::start()
{
    *this = {};
    ids = hazardIds();
    running = true;
}

float ExtremesStudy::done() const
{
    // All losses together take about as long as a third of the hazards.
    const auto hazards = static_cast<float>(ids.size());
    const float swept =
        lossesInAll == 0 ? 0.0F : 1.0F - static_cast<float>(lossesToGo.size()) / static_cast<float>(lossesInAll);
    return ids.empty() ? 0.0F : 0.75F * static_cast<float>(tried) / hazards + 0.25F * swept;
}

void ExtremesStudy::step(const Instruments& instruments)
{
    if (!running)
        return;
    if (tried < ids.size()) {
        for (Finding& finding : runExtremes(instruments, ids[tried++]))
            findings.push_back(std::move(finding));
        if (tried == ids.size()) {
            lossesToGo = sweepTasks(instruments);
            lossesInAll = lossesToGo.size();
            std::ranges::reverse(lossesToGo);
        }
    } else if (!lossesToGo.empty()) {
        losses.push_back(sweepRow(instruments, lossesToGo.back()));
        lossesToGo.pop_back();
    }
    running = tried < ids.size() || !lossesToGo.empty();
}

} // namespace reflectance::explorer
