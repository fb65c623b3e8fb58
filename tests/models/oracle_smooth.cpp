// Lambert and the mirror, in angles.
#include "tests/models/oracle_math.h"

namespace reflectance::test {
namespace {

Three lambert(const Inputs& x)
{
    return scaled(three(x, atI), x[atParameters] * cosineOfIncidence(x));
}

Three lambertColor(const Inputs& x)
{
    return matteBody(x, atParameters);
}

Three mirror(const Inputs& x)
{
    const Real radius = x[atRadius] * pi() / 180;
    const Real delta = angle(turnedAbout(three(x, atN), three(x, atL)), three(x, atV));
    return scaled(three(x, atI), above(x, atL) && delta < radius ? x[atParameters] : Real(0));
}

} // namespace

Formulas smoothFormulas()
{
    return {{"lambert", {{{"kd"}}, lambert}},
            {"lambert_color", {{{"K", 9}}, lambertColor}},
            {"mirror", {{{"reflectance"}}, mirror}}};
}

} // namespace reflectance::test
