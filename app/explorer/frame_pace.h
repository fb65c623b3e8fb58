// How long the window sleeps. It draws when something happened or something moves, and otherwise not at all.
#pragma once

#include <limits>

namespace reflectance::explorer {

/// What asks for another frame, seconds from now; infinity where nothing does.
struct Reasons {
    bool animating = false; ///< the turntable turns
    bool loading = false;   ///< a progress bar moves
    bool drawSoon = false;  ///< a panel waits for time to pass
    double untilRefined = 0.0;
    double untilPrices = 0.0;
    double untilAutosave = std::numeric_limits<double>::infinity();
};

class FramePace {
public:
    /// Seconds to wait for events before the next frame: 0 draws at once, infinity sleeps until something happens.
    [[nodiscard]] double secondsToWait(const Reasons& reasons) const;

    /// Call after waiting. Dear ImGui answers an input one frame late at times, and windows settle over two frames.
    void waited(bool somethingHappened);

private:
    int owed_ = 3;
};

} // namespace reflectance::explorer
