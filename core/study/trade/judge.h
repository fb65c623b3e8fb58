// Holds pictures against the truth.
#pragma once

#include "core/image/compare.h"
#include "core/image/perceived.h"

#include <string_view>

namespace reflectance {

/// By which figure a tolerance is meant.
enum class Metric { Max, Rmse, DeltaE };

[[nodiscard]] constexpr std::string_view nameOf(Metric metric)
{
    constexpr std::string_view names[] = {"max", "rmse", "de"};
    return names[static_cast<int>(metric)];
}

/// "largest difference (linear, white 1)".
[[nodiscard]] std::string_view labelOf(Metric metric);

/// Linear figures over every channel of every pixel, the object's rim included; dE2000 over the pixels that the object covers,
/// as a display shows them after the sensor's exposure; FLIP over the whole picture at the usual distance.
struct ErrorFigures {
    double max = 0.0, rmse = 0.0;
    double relative = 0.0; ///< largest; against at least a thousandth of white
    PerceivedDifference perceived;

    /// DeltaE: the value that 95 of 100 covered pixels stay below.
    [[nodiscard]] double by(Metric metric) const;
};

class Judge {
public:
    /// `gain`: what the sensor multiplies radiance by first.
    Judge(Image truth, double gain);

    /// The sizes must match.
    [[nodiscard]] ErrorFigures errorOf(const Image& picture) const;
    [[nodiscard]] const Image& truth() const { return truth_; }
    /// Whether the object is seen at all.
    [[nodiscard]] bool seesObject() const;

private:
    [[nodiscard]] Image exposed(Image image) const;

    Image truth_;
    float factor_;
    PerceivedReference reference_;
};

} // namespace reflectance
