#include "app/explorer/frame_pace.h"

#include <algorithm>
#include <limits>

namespace reflectance::explorer {

double FramePace::secondsToWait(const Reasons& reasons) const
{
    if (owed_ > 0 || reasons.animating)
        return 0.0;
    constexpr double never = std::numeric_limits<double>::infinity();
    return std::max(0.0, std::min({reasons.loading ? 0.05 : never, reasons.drawSoon ? 0.1 : never, reasons.untilRefined,
                                   reasons.untilPrices, reasons.untilAutosave}));
}

void FramePace::waited(bool somethingHappened)
{
    owed_ = somethingHappened ? 3 : std::max(0, owed_ - 1);
}

} // namespace reflectance::explorer
