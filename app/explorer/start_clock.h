// From the start of the process to the first picture in the window, stage by stage.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace reflectance::explorer {

class StartClock {
public:
    StartClock();

    /// What has just been done. Notes after the first "shown" are ignored.
    void note(const char* stage);

    [[nodiscard]] bool done() const; ///< the first picture has been shown
    /// "First picture after 0.61 s."; empty before.
    [[nodiscard]] std::string sentence() const;
    /// The sentence, and a line for each stage with its milliseconds.
    [[nodiscard]] std::string report() const;

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point
        start_; ///< of the process, to a hundredth of a second, where the system tells; else of this clock
    std::vector<std::pair<const char*, double>> stages_; ///< and seconds from the start to its end
};

} // namespace reflectance::explorer
