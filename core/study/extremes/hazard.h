// A hazard as data: a row of the tables in lobe.cpp, vectors.cpp and their neighbours.
#pragma once

#include "core/study/extremes/exhibit.h"

namespace reflectance {

struct Hazard {
    std::string id;                       ///< "H04"
    std::string danger;                   ///< what can go wrong
    std::string input;                    ///< what is put in
    std::string expected;                 ///< in words, with figures that do not come from the shipped code
    std::vector<Precision> precisions;    ///< empty: once, no model computes
    std::vector<std::string> models = {}; ///< without all of these the hazard does not apply yet
    std::function<Outcome(Bench&)> check = {};
    Show show = {};           ///< the case as a picture
    std::string missing = {}; ///< the part of the program that does not exist yet; then there is no check
};

using Hazards = std::vector<Hazard>;

inline const std::vector<Precision> inEveryPrecision{Precision::Double, Precision::Float, Precision::Simd,
                                                     Precision::Glsl};

[[nodiscard]] Hazards lobeHazards();
[[nodiscard]] Hazards highlightHazards();
[[nodiscard]] Hazards vectorHazards();
[[nodiscard]] Hazards meshHazards();
[[nodiscard]] Hazards pictureHazards();
[[nodiscard]] Hazards matrixHazards();
[[nodiscard]] Hazards roughHazards();
[[nodiscard]] Hazards lightHazards();
[[nodiscard]] Hazards sensorHazards();
[[nodiscard]] Hazards arithmeticHazards();

} // namespace reflectance
