// What the formulas of the oracles are written in: 50 digits, angles, and all inputs of a formula in one list.
#pragma once

#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <map>
#include <string>
#include <vector>

namespace reflectance::test {

using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;
using Three = std::array<Real, 3>;

/// All inputs of a formula in one list, so that each can be moved in turn: N, L, V (raw), I, radius, parameters.
using Inputs = std::vector<Real>;
inline constexpr std::size_t atN = 0, atL = 3, atV = 6, atI = 9, atRadius = 12, atParameters = 13;

/// A parameter and how many numbers the formula reads of it; one number is spread over three, 0 reads all of a list.
struct Read {
    std::string name;
    std::size_t count = 1;
};

struct Formula {
    std::vector<Read> parameters; ///< in the order in which the formula reads them
    Three (*value)(const Inputs&);
    /// What the model's exponential is multiplied by, but for the light: float may cut it to 0 below the smallest normal
    /// number. Without one, 1.
    Real (*height)(const Inputs&) = nullptr;
};
using Formulas = std::map<std::string, Formula>;

/// One list per family of models.
[[nodiscard]] Formulas smoothFormulas();    ///< Lambert and the mirror
[[nodiscard]] Formulas highlightFormulas(); ///< powers of a cosine: Phong and Blinn
[[nodiscard]] Formulas roughFormulas();     ///< matte with a profile: Oren-Nayar and its kin
[[nodiscard]] Formulas facetFormulas();     ///< tiny mirrors: Cook-Torrance, Ward, GGX
[[nodiscard]] Formulas scatteringFormulas(); ///< Koenderink's modes

[[nodiscard]] const Real& pi();
[[nodiscard]] Three three(const Inputs& inputs, std::size_t at);
[[nodiscard]] Real dot(const Three& a, const Three& b);
[[nodiscard]] Three cross(const Three& a, const Three& b);
[[nodiscard]] Three scaled(const Three& v, const Real& factor);
[[nodiscard]] Three sum(const Three& a, const Three& b);

/// The angle between two vectors of any length; exactly pi/2 only where the dot product is 0.
[[nodiscard]] Real angle(const Three& a, const Three& b);

/// v / |v|; the zero vector stays.
[[nodiscard]] Three unit(const Three& v);

/// A turned by 180 degrees about the axis N: the part along N stays, the part across it changes sign.
[[nodiscard]] Three turnedAbout(const Three& N, const Three& A);

/// True where the angle of N and the vector at `at` is below 90 degrees, the horizon itself excluded.
[[nodiscard]] bool above(const Inputs& x, std::size_t at);

/// cos(angle of N and L) where the surface is lit, else 0.
[[nodiscard]] Real cosineOfIncidence(const Inputs& x);

/// K I with K's nine numbers at `at`.
[[nodiscard]] Three matrixTimesLight(const Inputs& x, std::size_t at);

/// K I cos(angle of N and L).
[[nodiscard]] Three matteBody(const Inputs& x, std::size_t atK);

/// The largest of the parameter's three numbers at `at`.
[[nodiscard]] Real largest(const Inputs& x, std::size_t at);

/// The parameter's three numbers at `at` times I, channel by channel.
[[nodiscard]] Three colorTimesLight(const Inputs& x, std::size_t at);

} // namespace reflectance::test
