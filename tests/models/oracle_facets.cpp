// Tiny mirrors, in the angles of the papers: theta_h between N and the half vector, theta_d between it and the viewer.
#include "tests/models/oracle_math.h"

#include <algorithm>

namespace reflectance::test {
namespace {

struct Angles {
    Real L, V; ///< from N
    Real h;    ///< of the half vector from N
    Real d;    ///< of the viewer from the half vector
};

Angles anglesOf(const Inputs& x)
{
    const Three N = three(x, atN);
    const Three half = sum(unit(three(x, atL)), unit(three(x, atV)));
    return {angle(N, three(x, atL)), angle(N, three(x, atV)), angle(N, half), angle(half, three(x, atV))};
}

bool seen(const Inputs& x)
{
    return above(x, atL) && above(x, atV);
}

Real squared(const Real& v)
{
    return v * v;
}

/// Schlick: f0 + (1 - f0) (1 - cos)^5 per channel, times I.
Three fresnelTimesLight(const Inputs& x, std::size_t at, const Real& cosine)
{
    Three result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = (x[at + i] + (1 - x[at + i]) * squared(squared(1 - cosine)) * (1 - cosine)) * x[atI + i];
    return result;
}

/// Cook-Torrance reads m, f0, ks, K.
constexpr std::size_t atM = atParameters, atF0 = atParameters + 1, atScale = atParameters + 4,
                      atBody = atParameters + 7;

/// pi D G / (4 cos(V)) without the exponential in D.
Real cookHeight(const Inputs& x)
{
    if (!seen(x))
        return 0;
    const Angles a = anglesOf(x);
    const Real common = 2 * cos(a.h) / cos(a.d);
    const Real G = std::min({Real(1), Real(common * cos(a.V)), Real(common * cos(a.L))});
    return G / (squared(x[atM]) * squared(squared(cos(a.h))) * 4 * cos(a.V));
}

Three cookTorrance(const Inputs& x)
{
    if (!seen(x))
        return {};
    const Angles a = anglesOf(x);
    const Real gloss = cookHeight(x) * exp(-squared(tan(a.h) / x[atM]));
    Three result = matteBody(x, atBody);
    const Three F = fresnelTimesLight(x, atF0, cos(a.d));
    for (std::size_t i = 0; i < 3; ++i)
        result[i] += F[i] * x[atScale + i] * gloss;
    return result;
}

Real largestCookHeight(const Inputs& x)
{
    return largest(x, atScale) * cookHeight(x);
}

/// Ward reads ks, alpha, K.
Real wardHeight(const Inputs& x, bool root)
{
    if (!seen(x))
        return 0;
    const Angles a = anglesOf(x);
    const Real cosines = cos(a.L) * cos(a.V);
    return cos(a.L) / (4 * squared(x[atParameters + 3]) * (root ? Real(sqrt(cosines)) : cosines));
}

Three ward(const Inputs& x, bool root)
{
    if (!seen(x))
        return {};
    const Real gloss = wardHeight(x, root) * exp(-squared(tan(anglesOf(x).h) / x[atParameters + 3]));
    return sum(matteBody(x, atParameters + 4), scaled(colorTimesLight(x, atParameters), gloss));
}

Three wardOfWard(const Inputs& x)
{
    return ward(x, true);
}

Three wardOfDuer(const Inputs& x)
{
    return ward(x, false);
}

Real heightOfWard(const Inputs& x)
{
    return largest(x, atParameters) * wardHeight(x, true);
}

Real heightOfDuer(const Inputs& x)
{
    return largest(x, atParameters) * wardHeight(x, false);
}

/// GGX reads alpha, f0. With tangents: D = 1 / (pi alpha^2 cos^4 (1 + tan^2 / alpha^2)^2), and Smith's
/// G2 = 2 / (sqrt(1 + alpha^2 tan(L)^2) + sqrt(1 + alpha^2 tan(V)^2)), height-correlated.
Three ggx(const Inputs& x)
{
    if (!seen(x))
        return {};
    const Angles a = anglesOf(x);
    const Real alpha = x[atParameters];
    const Real D = 1 / (pi() * squared(alpha * squared(cos(a.h)) * (1 + squared(tan(a.h) / alpha))));
    const Real G = 2 / (sqrt(1 + squared(alpha * tan(a.L))) + sqrt(1 + squared(alpha * tan(a.V))));
    return scaled(fresnelTimesLight(x, atParameters + 1, cos(a.d)), pi() * D * G / (4 * cos(a.V)));
}

} // namespace

Formulas facetFormulas()
{
    return {{"cook_torrance", {{{"m"}, {"f0", 3}, {"ks", 3}, {"K", 9}}, cookTorrance, largestCookHeight}},
            {"ward", {{{"ks", 3}, {"alpha"}, {"K", 9}}, wardOfWard, heightOfWard}},
            {"ward_duer", {{{"ks", 3}, {"alpha"}, {"K", 9}}, wardOfDuer, heightOfDuer}},
            {"ggx", {{{"alpha"}, {"f0", 3}}, ggx}}};
}

} // namespace reflectance::test
