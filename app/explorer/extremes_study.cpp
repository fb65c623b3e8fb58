#include "app/explorer/extremes_study.h"

namespace reflectance::explorer {

void ExtremesStudy::start()
{
    findings.clear();
    ids = hazardIds();
    tried = 0;
    running = true;
}

float ExtremesStudy::done() const
{
    return ids.empty() ? 0.0F : static_cast<float>(tried) / static_cast<float>(ids.size());
}

void ExtremesStudy::step(const Instruments& instruments)
{
    if (!running)
        return;
    if (tried < ids.size())
        for (Finding& finding : runExtremes(instruments, ids[tried++]))
            findings.push_back(std::move(finding));
    running = tried < ids.size();
}

} // namespace reflectance::explorer
