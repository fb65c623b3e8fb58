// Measured response curves: their file, their values between lines, and what is refused.
#include "core/sensor/sensor.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

Sensor withCurve(std::string_view csv)
{
    Sensor sensor;
    sensor.encoding.on = sensor.quantisation.on = false;
    sensor.response.on = true;
    sensor.response.kind = ResponseKind::Curve;
    auto curve = parseResponseCurve(csv, "curve.csv");
    EXPECT_TRUE(curve) << curve.error().sentence();
    if (curve)
        sensor.response.curve = std::make_shared<const ResponseCurve>(*std::move(curve));
    return sensor;
}

Vec3d at(const Sensor& sensor, double value)
{
    Image image(1, 1);
    std::fill(image.rgb.begin(), image.rgb.end(), static_cast<float>(value));
    return developedAt(image, 0, 0, sensor);
}

TEST(ResponseCurve, IsLinearBetweenItsLines)
{
    const Sensor sensor = withCurve("light, response\n# measured\n0, 0\n0.25, 0.5\n1, 1\n");
    // Texels are floats: 2^-24.
    for (const auto& [light, response] :
         {std::pair{0.0, 0.0}, {0.125, 0.25}, {0.25, 0.5}, {0.625, 0.75}, {1.0, 1.0}, {3.0, 1.0}})
        EXPECT_NEAR(at(sensor, light).y, response, 6e-8) << light;
}

TEST(ResponseCurve, HasItsOwnChannelsAndScales)
{
    const Sensor sensor = withCurve("0;0;0;10\n512;64;32;10\n1024;128;128;64\n");
    const Vec3d half = at(sensor, 0.5);
    EXPECT_NEAR(half.x, 0.5, 6e-8);
    EXPECT_NEAR(half.y, 0.25, 6e-8);
    EXPECT_NEAR(half.z, 10.0 / 128.0, 6e-8);
    EXPECT_NEAR(at(sensor, 0.0).z, 10.0 / 128.0, 6e-8) << "a black level of its own";
    EXPECT_NEAR(at(sensor, std::nan("")).z, 10.0 / 128.0, 6e-8) << "no number is no light";
}

TEST(ResponseCurve, AGammaAsAFileIsThatGamma)
{
    std::string csv;
    for (int i = 0; i <= 1023; ++i)
        csv += std::to_string(i / 1023.0) + " " + std::to_string(std::pow(i / 1023.0, 1.0 / 2.2)) + "\n";
    const Sensor sensor = withCurve(csv);
    // Between lines 1/1023 apart: h^2 / 8 times the second derivative, 0.25 x^(1/2.2 - 2), at 0.1: 1.1e-6; printed to 5e-7.
    for (const double light : {0.1, 0.3, 0.9})
        EXPECT_NEAR(at(sensor, light).x, std::pow(light, 1.0 / 2.2), 3e-6);
}

TEST(ResponseCurve, ReadTwiceIsOneCurve)
{
    EXPECT_TRUE(withCurve("0,0\n0.25,0.5\n1,1\n") == withCurve("0,0\n0.25,0.5\n1,1\n"));
    EXPECT_FALSE(withCurve("0,0\n0.25,0.5\n1,1\n") == withCurve("0,0\n0.25,0.6\n1,1\n"));
    Sensor none = withCurve("0,0\n1,1\n");
    none.response.curve = nullptr;
    EXPECT_FALSE(none == withCurve("0,0\n1,1\n"));
}

struct BadCurve {
    const char* csv;
    const char* sentence;
};

TEST(ResponseCurve, WhatIsWrongIsSaidInOneSentence)
{
    for (const auto& [csv, sentence] :
         {BadCurve{"", "fewer than two lines"}, BadCurve{"a,b\n", "fewer than two lines"},
          BadCurve{"0,0\n", "fewer than two lines"}, BadCurve{"0,0\n1,0\n", "every response is 0"},
          BadCurve{"0,0\n1,x\n", "curve.csv:2: 'x' is not a number from 0 on"},
          BadCurve{"0,0\n1,nan\n", "'nan' is not a number"}, BadCurve{"0,0\n1,-1\n", "'-1' is not a number from 0 on"},
          BadCurve{"0,0\n0,1\n", "light 0 follows 0; sort"}, BadCurve{"0,1\n1,0.5\n", "falls from 1 to 0.5"},
          BadCurve{"0,0,0\n1,1,1\n", "there are 3 columns"}}) {
        const auto curve = parseResponseCurve(csv, "curve.csv");
        ASSERT_FALSE(curve) << csv;
        EXPECT_NE(curve.error().sentence().find(sentence), std::string::npos) << curve.error().sentence();
    }
}

} // namespace
} // namespace reflectance
