// From linear radiance to code values: the curve, the rounding, and what could not be shown.
#include "core/sensor/sensor.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace reflectance {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Image ofValues(const std::vector<float>& values)
{
    Image image(static_cast<int>(values.size()), 1);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.rgb[3 * i + c] = values[i];
    return image;
}

std::uint8_t codeOf(float radiance, double exposure = 0.0)
{
    return develop(ofValues({radiance}), {exposure}).rgb[0];
}

/// How many codes come back changed when `decode` is taken for the inverse of the sensor's curve.
template <class Decode> int codesLost(Decode decode)
{
    int lost = 0;
    for (int code = 0; code < 256; ++code)
        lost += codeOf(static_cast<float>(decode(code / 255.0))) != code;
    return lost;
}

/// IEC 61966-2-1 in long double, written apart from the shipped text.
long double exactSrgb(long double x)
{
    if (x <= 0.0031308L)
        return 12.92L * x;
    return 1.055L * std::exp(std::log(x) / 2.4L) - 0.055L;
}

TEST(Sensor, H53_EveryCodeSurvivesDecodingAndDeveloping)
{
    EXPECT_EQ(codesLost(decodeSrgb), 0);
}

TEST(Sensor, APowerOf2_2InPlaceOfTheCurveWouldBeFound)
{
    EXPECT_GT(codesLost([](double x) { return std::pow(x, 2.2); }), 100);
}

TEST(Sensor, CodesAreThoseOfTheExactCurve)
{
    for (int i = 0; i <= 4096; ++i) {
        const float linear = static_cast<float>(i) / 4096.0F;
        const long double scaled = 255.0L * exactSrgb(linear);
        // Within 1e-9 of a tie the last bits of pow decide, and either code is right.
        if (std::fabs(scaled - std::floor(scaled) - 0.5L) < 1e-9L)
            continue;
        EXPECT_EQ(codeOf(linear), static_cast<int>(std::floor(scaled + 0.5L))) << "linear " << linear;
    }
}

TEST(Sensor, EncodingAndDecodingAreInverse)
{
    for (double x = 0.0; x <= 1.0; x += 1.0 / 997.0)
        // The standard's two pieces meet only to 3e-8 in x, so a value between them returns through the other piece.
        EXPECT_NEAR(decodeSrgb(encodeSrgb(x)), x, 1e-7);
    EXPECT_EQ(encodeSrgb(0.0), 0.0);
    // 1.055 * 1 - 0.055 rounds twice.
    EXPECT_NEAR(encodeSrgb(1.0), 1.0, 3e-16);
}

TEST(Sensor, H51_NegativeAndNaNAreBlackInfinityIsWhite)
{
    EXPECT_EQ(codeOf(-0.1F), 0);
    EXPECT_EQ(codeOf(-infinity), 0);
    EXPECT_EQ(codeOf(nan), 0);
    EXPECT_EQ(codeOf(infinity), 255);
    EXPECT_EQ(codeOf(1e30F), 255);
}

TEST(Sensor, H52_TiesRoundUp)
{
    EXPECT_EQ(quantised(0.5), 128); // 255 * 0.5 = 127.5 is the one tie that doubles represent exactly
    EXPECT_EQ(quantised(0.0), 0);
    EXPECT_EQ(quantised(1.0), 255);
    for (int code = 0; code < 255; ++code) {
        EXPECT_EQ(quantised((code + 0.5 - 1e-9) / 255.0), code);
        EXPECT_EQ(quantised((code + 0.5 + 1e-9) / 255.0), code + 1);
    }
}

TEST(Sensor, QuantisationKeepsToTheCodesForAnyNumber)
{
    EXPECT_EQ(quantised(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(quantised(-1.0), 0);
    EXPECT_EQ(quantised(7.0), 255);
    EXPECT_EQ(quantised(std::numeric_limits<double>::infinity()), 255);
}

TEST(Sensor, H54_ALinearRampReachesEveryCode)
{
    std::set<int> codes;
    for (int i = 0; i <= 65535; ++i)
        codes.insert(codeOf(static_cast<float>(i) / 65535.0F));
    EXPECT_EQ(codes.size(), 256U);
}

TEST(Sensor, ExposureMultipliesByPowersOfTwo)
{
    for (int stop = -8; stop <= 8; ++stop)
        // Powers of two scale floats without rounding, so the codes are equal, not close.
        EXPECT_EQ(codeOf(0.2F, stop), codeOf(std::ldexp(0.2F, stop))) << "EV " << stop;
    EXPECT_EQ(codeOf(0.25F, 0.5), quantised(encodeSrgb(0.25 * std::sqrt(2.0))));
}

TEST(Sensor, CountsPixelsNotChannels)
{
    Image image(5, 1);
    image.rgb = {-1, -1, 0.5F, 2, 3, 4, nan, infinity, 0, 0, 0.5F, 1, -infinity, 2, nan};
    const SensorCounts counts = develop(image, {}).counts;
    EXPECT_EQ(counts.negative, 2U);
    EXPECT_EQ(counts.clipped, 3U);
    EXPECT_EQ(counts.nonFinite, 2U);
}

TEST(Sensor, ClippingIsCountedAfterExposure)
{
    EXPECT_EQ(develop(ofValues({0.6F, 1.0F}), {1.0}).counts.clipped, 2U);
    EXPECT_EQ(develop(ofValues({1.9F, 1.0F}), {-1.0}).counts.clipped, 0U);
}

} // namespace
} // namespace reflectance
