#include "tests/models/oracle_math.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>

namespace reflectance::test {

const Real& pi()
{
    static const Real value = boost::math::constants::pi<Real>();
    return value;
}

Three three(const Inputs& inputs, std::size_t at)
{
    return {inputs[at], inputs[at + 1], inputs[at + 2]};
}

Real dot(const Three& a, const Three& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Three cross(const Three& a, const Three& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Three scaled(const Three& v, const Real& factor)
{
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

Three sum(const Three& a, const Three& b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Real angle(const Three& a, const Three& b)
{
    const Three c = cross(a, b);
    return atan2(sqrt(dot(c, c)), dot(a, b));
}

Three unit(const Three& v)
{
    const Real length = sqrt(dot(v, v));
    return length == 0 ? v : scaled(v, 1 / length);
}

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

bool above(const Inputs& x, std::size_t at)
{
    return dot(three(x, atN), three(x, at)) > 0;
}

Real cosineOfIncidence(const Inputs& x)
{
    return above(x, atL) ? Real(cos(angle(three(x, atN), three(x, atL)))) : Real(0);
}

Three matrixTimesLight(const Inputs& x, std::size_t at)
{
    const Three I = three(x, atI);
    return {dot(three(x, at), I), dot(three(x, at + 3), I), dot(three(x, at + 6), I)};
}

Three matteBody(const Inputs& x, std::size_t atK)
{
    return scaled(matrixTimesLight(x, atK), cosineOfIncidence(x));
}

Real largest(const Inputs& x, std::size_t at)
{
    return std::max({x[at], x[at + 1], x[at + 2]});
}

Three colorTimesLight(const Inputs& x, std::size_t at)
{
    return {x[at] * x[atI], x[at + 1] * x[atI + 1], x[at + 2] * x[atI + 2]};
}

} // namespace reflectance::test
