// What a fit is given: directions, light, and what was seen there; from a measured table, or from the pixels of a picture.
#pragma once

#include "core/measured/measurement.h"
#include "core/reflectance/observation.h"

#include <cstddef>
#include <string>
#include <vector>

namespace reflectance {

/// Grey: one number each, the same for every channel. Color: three, that do not mix. Matrix: three under coloured lights, so
/// that the nine numbers of a K can be told apart.
enum class ObservedForm { Grey, Color, Matrix };

/// One row is one pair of directions (or one pixel with its lights). As many `seen` and `cosine` as rows.
struct Observations {
    std::string name; ///< of the surface, for reports
    ObservedForm form = ObservedForm::Grey;
    std::vector<Observation> rows;
    std::vector<Vec3d> seen;    ///< the lecture's factor times the light, cosine included: pi f I (N.L); grey in x
    std::vector<double> cosine; ///< N.L where the row has one light and its BRDF is asked for; 1 for pixels

    [[nodiscard]] std::size_t channels() const { return form == ObservedForm::Grey ? 1 : 3; }
    [[nodiscard]] std::size_t numbers() const { return rows.size() * channels(); }
};

/// Takes f (1/sr) at a pair of directions about N = (0,0,1). A matrix becomes three rows, one per light primary.
void observe(Observations& observations, const Vec3d& L, const Vec3d& V, const Mat3d& f);

/// The samples of a table, holes and directions below the surface left out. Of more than `most` samples every k-th is
/// taken, k being the smallest odd number that is enough. The form follows the channels.
[[nodiscard]] Observations observationsOf(const Table& table, std::size_t most = 20000);

/// The same of anything measured: scattered samples as they were taken; RGL's function, which has no samples of its own, over
/// half and difference angles, dense near the mirror direction and at least 10 degrees above the horizon.
[[nodiscard]] Observations observationsOf(const Measurement& measurement);

/// The same surface without its colour: the mean of the channels.
[[nodiscard]] Observations greyOf(const Observations& observations);

/// The smallest angle between V and the mirror direction of L over all rows and lights, radians; pi without rows.
[[nodiscard]] double nearestMirror(const Observations& observations);

} // namespace reflectance
