// What the lecture's formulas give, to 50 digits: written from their angles, independent of the shipped texts, and with
// the sensitivity to rounded inputs that any arithmetic has to live with.
#pragma once

#include "core/math/vec.h"
#include "core/reflectance/catalogue.h"
#include "core/reflectance/observation.h"

#include <array>
#include <string>

namespace reflectance::test {

/// One row with one light, and the parameters by name.
struct OracleCase {
    std::string model;
    ParameterValues parameters;
    Vec3d N, L, V; ///< any length
    Vec3d I{1.0, 1.0, 1.0};
    double radius = 0.0; ///< of the light, degrees

    [[nodiscard]] Observation observation() const { return {N, V, {{L, I, radius}}}; }
};

struct OracleAnswer {
    Vec3d value;     ///< the true value, rounded to double
    Vec3d remainder; ///< what that rounding left: value + remainder has 32 digits
    /// How far the value moves per unit roundoff, kappa |value|: the sum over all inputs of |change| / 16 eps, where
    /// each component of N, L and V is moved by 16 eps of the vector's length, all else by 16 eps of itself. That far
    /// roundings can together carry a row across the rim of a light or the horizon, where values jump. worstRatio() looks
    /// nearer as well, for what is narrower than that.
    Vec3d sensitivity;
    double height = 1.0; ///< what the model's exponential is multiplied by, but for the light
};

/// `eps` is the unit roundoff of the arithmetic under test: 2^-53 or 2^-24.
[[nodiscard]] OracleAnswer oracle(const OracleCase& c, double eps);

/// What may be lost of the value because lanes and GPUs flush an exponential to zero below the smallest normal number: that
/// number times what multiplies it, the light and the highlight's height.
[[nodiscard]] double flushed(const OracleCase& c, const OracleAnswer& truth, bool isDouble);

/// True where a model's formula asks for H = (L + V) / |L + V| and L and V are opposite to within 64 roundoffs: rounding L and V
/// turns H by more than highlights are wide, so no arithmetic of that roundoff can say on which side of one it lies.
[[nodiscard]] bool hasNoHalfVector(const OracleCase& c, double eps);

/// |got - true| / (32 (kappa + 1) eps |true| + floor), the largest of the three channels. The floor is the smallest
/// normal number of the arithmetic times the highlight's peak: below it, lanes and GPUs flush to zero.
/// In float, |N.L| < 4 eps cannot be told from 0: 32 eps |I| is added there. Without a half vector any finite
/// number has the ratio 0.
[[nodiscard]] double ratioToBound(const OracleCase& c, const Vec3d& got, bool isDouble);
/// The same with the oracle's answer at hand.
[[nodiscard]] double ratioToBound(const OracleCase& c, const OracleAnswer& truth, const Vec3d& got, bool isDouble);

/// The larger of `worst` and the row's ratio to the bound. Each input's share of the sensitivity widens the bound; once it
/// is wide enough for `worst`, the other inputs are not asked. Most rows then cost a few answers instead of thirty or, with
/// lists of coefficients, a hundred and forty.
[[nodiscard]] double worstRatio(double worst, const OracleCase& c, const Vec3d& got, bool isDouble);

} // namespace reflectance::test
