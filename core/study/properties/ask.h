// A finding: the worst place that a property was looked at, and how bad it was there. And short ways to ask a model.
#pragma once

#include "core/reflectance/catalogue.h"
#include "core/reflectance/precision.h"
#include "core/study/properties/samples.h"

#include <array>
#include <span>
#include <string>

namespace reflectance::properties {

/// How many places are looked at.
struct Effort {
    std::size_t parameterSets = 24; ///< besides defaults, ends and landmarks
    std::size_t directions = 200;
};
[[nodiscard]] inline Effort thoroughEffort()
{
    return {300, 2000};
}

/// Where something was found.
struct Place {
    std::vector<double> values; ///< the model's flat list
    Directions directions;      ///< V is zero where all viewers were summed over, L where all lights were
    Precision precision = Precision::Double;
};

struct Finding {
    bool applies = true; ///< false: the model has nothing that this property speaks of
    double worst = 0.0;  ///< in the property's own measure, infinite where a value was not a number
    Place at;
    std::string note;

    /// Keeps the largest; anything that is not a number counts as infinitely bad.
    void see(double badness, const Place& place);
};

inline constexpr std::array corePrecisions{Precision::Double, Precision::Float, Precision::Simd};

/// Half the distance from 1 to the next number of this precision.
[[nodiscard]] constexpr double unitRoundoff(Precision precision)
{
    return precision == Precision::Double ? 0x1p-53 : 0x1p-24;
}

/// The model at one place for a light of colour I. A model that sees the size of lights gets one of discRadius.
[[nodiscard]] Vec3d valueAt(const Model& model, const Place& place, const Vec3d& I = Vec3d(1.0));

inline constexpr double discRadius = 5.0; ///< degrees

[[nodiscard]] double largestOf(const Vec3d& v); ///< of the magnitudes; infinite if one is not a number
[[nodiscard]] double smallestOf(const Vec3d& v);

/// "ks=1;n=40" and "light at 80, viewer at 30 degrees, azimuth 120".
[[nodiscard]] std::string valuesText(const ModelText& model, std::span<const double> values);
[[nodiscard]] std::string directionsText(const Directions& directions);

/// Calls look(place) for every parameter sample and every direction.
template <class Look>
void everywhere(const Model& model, const Effort& effort, std::span<const Directions> directions, const Look& look)
{
    for (const auto& values : parameterSamples(model.text, effort.parameterSets))
        for (const Directions& d : directions)
            look(Place{values, d});
}

} // namespace reflectance::properties
