// Lambert, the mirror and the lecture's highlights, in angles.
#include "tests/models/oracle_math.h"

namespace reflectance::test {
namespace {

/// A turned by 180 degrees about the axis N: the part along N stays, the part across it changes sign.
Three turnedAbout(const Three& N, const Three& A)
{
    const Real along = dot(N, A) / dot(N, N);
    Three result;
    for (std::size_t i = 0; i < 3; ++i) {
        const Real part = along * N[i];
        result[i] = part - (A[i] - part);
    }
    return result;
}

Real angleToMirror(const Inputs& x)
{
    return angle(turnedAbout(three(x, atN), three(x, atL)), three(x, atV));
}

Real highlight(const Inputs& x, const Real& n)
{
    const Real delta = angleToMirror(x);
    if (!above(x, atL) || delta >= pi() / 2)
        return 0;
    return exp(n * log(cos(delta)));
}

Three lambert(const Inputs& x)
{
    return scaled(three(x, atI), x[atParameters] * cosineOfIncidence(x));
}

Three lambertColor(const Inputs& x)
{
    return scaled(matrixTimesLight(x, atParameters), cosineOfIncidence(x));
}

Three mirror(const Inputs& x)
{
    const Real radius = x[atRadius] * pi() / 180;
    return scaled(three(x, atI), above(x, atL) && angleToMirror(x) < radius ? x[atParameters] : Real(0));
}

Three phong(const Inputs& x)
{
    return scaled(three(x, atI), x[atParameters] * highlight(x, x[atParameters + 1]));
}

Three hybrid(const Inputs& x)
{
    const Three matte = scaled(matrixTimesLight(x, atParameters), cosineOfIncidence(x));
    return sum(matte, scaled(three(x, atI), x[atParameters + 9] * highlight(x, x[atParameters + 10])));
}

} // namespace

Formulas smoothFormulas()
{
    return {{"lambert", {{"kd"}, lambert}},
            {"lambert_color", {{"K"}, lambertColor}},
            {"mirror", {{"reflectance"}, mirror}},
            {"phong", {{"ks", "n"}, phong}},
            {"hybrid", {{"K", "ks", "n"}, hybrid}}};
}

} // namespace reflectance::test
