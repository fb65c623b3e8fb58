// How far each model carries in each arithmetic: the first exponent, angle or length at which it loses three digits, as
// a textbook writes it and as this program does.
#pragma once

#include "core/study/extremes/instruments.h"

#include <optional>
#include <string>
#include <vector>

namespace reflectance {

/// Three digits are lost where the relative error exceeds this many units of roundoff (2^-53; 2^-24 for all else).
inline constexpr double unitsOfThreeDigits = 1000.0;

struct SweepRow {
    std::string model;
    std::string swept;              ///< "n at half the peak"
    std::string arithmetic;         ///< "double", "float", "simd", "glsl"
    double last = 0.0;              ///< where the sweep ends
    std::optional<double> textbook; ///< first point of loss; none up to `last`
    std::optional<double> ours;
};

/// A row that is still to be computed.
struct SweepTask {
    std::string model;
    std::size_t sweep; ///< index among the model's
    Precision precision;
};

/// Models without a textbook form are left out, GLSL where it does not run.
[[nodiscard]] std::vector<SweepTask> sweepTasks(const Instruments& instruments);
[[nodiscard]] SweepRow sweepRow(const Instruments& instruments, const SweepTask& task);

/// All of them.
[[nodiscard]] std::vector<SweepRow> sweepExtremes(const Instruments& instruments);

} // namespace reflectance
