// Powers of the cosine of an angle: to the mirrored light (Phong), or of the half vector to N (Blinn).
#include "tests/models/oracle_math.h"

namespace reflectance::test {
namespace {

/// cos(delta)^n where the surface is lit and delta is below a right angle, else 0.
Real power(const Inputs& x, const Real& delta, const Real& n)
{
    return !above(x, atL) || delta >= pi() / 2 ? Real(0) : Real(exp(n * log(cos(delta))));
}

Real fromMirror(const Inputs& x, const Real& n)
{
    return power(x, angle(turnedAbout(three(x, atN), three(x, atL)), three(x, atV)), n);
}

Real fromNormal(const Inputs& x, const Real& n)
{
    const Three half = sum(unit(three(x, atL)), unit(three(x, atV)));
    return dot(half, half) == 0 ? Real(0) : power(x, angle(three(x, atN), half), n);
}

/// Where the formulas read: ks, n, then K if there is one; the hybrid reads K first.
constexpr std::size_t atKs = atParameters, atExponent = atParameters + 3, atK = atParameters + 4;

Three phong(const Inputs& x)
{
    return scaled(colorTimesLight(x, atKs), fromMirror(x, x[atExponent]));
}

Three hybrid(const Inputs& x)
{
    return sum(matteBody(x, atParameters),
               scaled(colorTimesLight(x, atParameters + 9), fromMirror(x, x[atParameters + 12])));
}

Real normalisation(const Inputs& x)
{
    return (x[atExponent] + 2) / 2 * cosineOfIncidence(x);
}

Three phongNormalized(const Inputs& x)
{
    return scaled(phong(x), normalisation(x));
}

Three blinnGloss(const Inputs& x)
{
    return scaled(colorTimesLight(x, atKs), fromNormal(x, x[atExponent]));
}

Three blinnPhong(const Inputs& x)
{
    return sum(matteBody(x, atK), blinnGloss(x));
}

Three blinnPhongNormalized(const Inputs& x)
{
    return sum(matteBody(x, atK), scaled(blinnGloss(x), normalisation(x)));
}

Real peak(const Inputs& x)
{
    return largest(x, atKs);
}

Real hybridPeak(const Inputs& x)
{
    return largest(x, atParameters + 9);
}

Real normalisedPeak(const Inputs& x)
{
    return largest(x, atKs) * normalisation(x);
}

} // namespace

Formulas highlightFormulas()
{
    return {{"phong", {{{"ks", 3}, {"n"}}, phong, peak}},
            {"hybrid", {{{"K", 9}, {"ks", 3}, {"n"}}, hybrid, hybridPeak}},
            {"phong_normalized", {{{"ks", 3}, {"n"}}, phongNormalized, normalisedPeak}},
            {"blinn_phong", {{{"ks", 3}, {"n"}, {"K", 9}}, blinnPhong, peak}},
            {"blinn_phong_normalized", {{{"ks", 3}, {"n"}, {"K", 9}}, blinnPhongNormalized, normalisedPeak}}};
}

} // namespace reflectance::test
