// log2 and 2^y of the lobe against the C library's 64-bit extended precision.
#include "core/math/exponentials.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace reflectance {
namespace {

/// The larger of `worst` and the relative error in units of the type's roundoff.
template <class T> double worse(double worst, T got, long double truth)
{
    constexpr double roundoff = std::numeric_limits<T>::epsilon() / 2.0;
    return std::fmax(worst, static_cast<double>(std::fabs((static_cast<long double>(got) - truth) / truth)) / roundoff);
}

template <class T> class Exponential : public testing::Test {
};
using Types = testing::Types<float, double>;
TYPED_TEST_SUITE(Exponential, Types);

/// Five roundings: of m - 1 by none, of m + 1, the quotient, the polynomial, its product and the sum with k. 2 to 3 were met.
TYPED_TEST(Exponential, Log2KeepsItsDigitsOverAllNormalNumbers)
{
    using T = TypeParam;
    double worst = 0.0;
    for (T u = std::numeric_limits<T>::min(); u < T(1); u *= T(1.00371))
        worst = worse(worst, log2Of(u, u - T(1)), std::log2(static_cast<long double>(u)));
    EXPECT_LE(worst, 5.0);
}

/// Near 1 the number itself has lost what x knows: log2(1 + x) for x down to the smallest.
TYPED_TEST(Exponential, Log2TakesWhatIsBelowOneFromX)
{
    using T = TypeParam;
    double worst = 0.0;
    for (T x = T(-0.29); x < -std::numeric_limits<T>::min(); x *= T(0.9871))
        worst = worse(worst, log2Of(T(1) + x, x), std::log1p(static_cast<long double>(x)) / std::log(2.0L));
    EXPECT_LE(worst, 5.0);
    EXPECT_EQ(log2Of(T(1), T(0)), T(0));
}

/// y is exact here: what is left are the polynomial's sum and its last product.
TYPED_TEST(Exponential, PowersOfTwoKeepTheirDigitsAndEndAtTheSmallestNormalNumber)
{
    using T = TypeParam;
    const T lowest = std::log2(std::numeric_limits<T>::min());
    double worst = 0.0;
    for (T y = lowest; y <= T(0); y += T(0.00390625) * T(1.3))
        worst = worse(worst, exp2OrZero(y), std::exp2(static_cast<long double>(y)));
    EXPECT_LE(worst, 3.0);
    EXPECT_EQ(exp2OrZero(T(0)), T(1));
    EXPECT_EQ(exp2OrZero(lowest), std::numeric_limits<T>::min());
    for (const T y : {std::nextafter(lowest, T(-1e9)), T(-1e4), T(-1e9), -std::numeric_limits<T>::max(),
                      -std::numeric_limits<T>::infinity()})
        EXPECT_EQ(exp2OrZero(y), T(0)) << y;
}

/// The planted fault: one term less of a polynomial is seen.
TYPED_TEST(Exponential, TheBoundsRefuseAShorterPolynomial)
{
    using T = TypeParam;
    auto shorter = Exponentials<T>::P;
    shorter.back() = T(0);
    const T fraction = T(0.484375);
    EXPECT_GT(worse(0.0, polynomial(shorter, fraction), std::exp2(static_cast<long double>(fraction))), 3.0);
    EXPECT_LE(worse(0.0, polynomial(Exponentials<T>::P, fraction), std::exp2(static_cast<long double>(fraction))), 3.0);
}

} // namespace
} // namespace reflectance
