// Every part of the sensor against its closed form, alone; and that each can be switched.
#include "core/base/text.h"
#include "core/sensor/fields.h"
#include "core/sensor/inputs.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

Image ofValue(int width, int height, double value)
{
    Image image(width, height);
    std::fill(image.rgb.begin(), image.rgb.end(), static_cast<float>(value));
    return image;
}

/// Nothing but what a test switches on: linear values come out as they are, up to 1.
Sensor nothing()
{
    Sensor sensor;
    sensor.well.on = sensor.encoding.on = sensor.quantisation.on = false;
    return sensor;
}

Vec3d through(const Sensor& sensor, double radiance)
{
    return developedAt(ofValue(1, 1, radiance), 0, 0, sensor);
}

TEST(SensorParts, NothingLeavesLinearValues)
{
    for (const float value : {0.0F, 0.1F, 0.25F, 1.0F})
        EXPECT_EQ(through(nothing(), value), Vec3d(double{value}));
}

TEST(SensorParts, SunnySixteenFillsTheSensor)
{
    Sensor sensor;
    EXPECT_EQ(gainOf(sensor), 1.0);
    sensor.camera.on = true;
    // f/16, 1/100 s, ISO 100: full at 1.2 * 256 * 100 cd/m2. Four roundings.
    EXPECT_NEAR(gainOf(sensor), 1.0, 1e-15);
    sensor.camera.aperture = 8.0; // two stops more light
    EXPECT_NEAR(gainOf(sensor), 4.0, 4e-15);
    sensor.camera.shutter = 0.005; // one less
    sensor.camera.iso = 400.0;     // two more
    sensor.exposure = -1.0;        // one less
    EXPECT_NEAR(gainOf(sensor), 4.0, 4e-15);
    sensor.exposes = false;
    EXPECT_NEAR(gainOf(sensor), 8.0, 8e-15);
    // A perfect white diffuser in full sun, 100,000 lx, has 100000 / pi cd/m2: the old rule exposes it within a tenth of a stop.
    EXPECT_LT(std::fabs(std::log2(100000.0 / std::numbers::pi / sensor.camera.white)), 0.1);
}

TEST(SensorParts, VignettingIsCosineToTheFourth)
{
    Sensor sensor = nothing();
    sensor.vignetting = {true, FallOff::Cos4, 40.0, {}};
    const Image white = ofValue(101, 51, 1.0);
    EXPECT_EQ(developedAt(white, 50, 25, sensor).x, 1.0) << "the middle loses nothing";
    const double halfDiagonal = 0.5 * std::hypot(101.0, 51.0);
    for (const auto& [x, y] : {std::pair{0, 0}, {100, 50}, {0, 50}, {50, 0}, {13, 7}}) {
        const double r = std::hypot(x + 0.5 - 50.5, y + 0.5 - 25.5) / halfDiagonal;
        const double angle = std::atan(r * std::tan(40.0 * std::numbers::pi / 180.0));
        // A tangent, an arctangent and a power away: some ten roundings.
        EXPECT_NEAR(developedAt(white, x, y, sensor).x, std::pow(std::cos(angle), 4), 1e-14);
    }
    EXPECT_EQ(developedAt(white, 3, 5, sensor), developedAt(white, 97, 45, sensor)) << "symmetric";
}

TEST(SensorParts, VignettingByAPolynomialIsNeverNegative)
{
    Sensor sensor = nothing();
    sensor.vignetting = {true, FallOff::Polynomial, 0.0, {-0.3, 0.1, -0.05}};
    const Image white = ofValue(40, 30, 1.0);
    const double rr = (19.5 * 19.5 + 14.5 * 14.5) / (20.0 * 20.0 + 15.0 * 15.0);
    EXPECT_NEAR(developedAt(white, 0, 0, sensor).x, 1.0 - 0.3 * rr + 0.1 * rr * rr - 0.05 * rr * rr * rr, 1e-15);
    sensor.vignetting.polynomial = {-3.0, 0.0, 0.0};
    EXPECT_EQ(developedAt(white, 0, 0, sensor).x, 0.0);
}

TEST(SensorParts, TheWellCutsOffAndIsCounted)
{
    Sensor sensor = nothing();
    sensor.well = {true, 0.5};
    EXPECT_EQ(through(sensor, 0.25).x, 0.25);
    EXPECT_EQ(through(sensor, 0.75).x, 0.5);
    EXPECT_EQ(develop(ofValue(3, 2, 0.75), sensor).counts.clipped, 6U);
    sensor.well.on = false;
    EXPECT_EQ(through(sensor, 0.75).x, 0.75);
    EXPECT_EQ(develop(ofValue(3, 2, 0.75), sensor).counts.clipped, 0U);
    EXPECT_EQ(develop(ofValue(3, 2, 1.25), sensor).counts.clipped, 6U) << "the largest code clips, too";
}

TEST(SensorParts, BalanceComesBeforeTheMatrix)
{
    Sensor sensor = nothing();
    sensor.balance = {true, {2.0, 1.0, 0.5}, {0.5, 0.25, 0.0, 0.0, 1.0, 0.0, -0.125, 0.0, 1.0}};
    Image image(1, 1);
    image.rgb = {0.25F, 0.5F, 0.75F};
    // Powers of two: exact. Balanced: 0.5, 0.5, 0.375.
    EXPECT_EQ(developedAt(image, 0, 0, sensor), Vec3d(0.375, 0.5, 0.3125));
}

TEST(SensorParts, GammaIsAPower)
{
    Sensor sensor = nothing();
    sensor.response.on = true;
    sensor.response.gamma = 2.0;
    EXPECT_NEAR(through(sensor, 0.25).x, 0.5, 1e-15);
    EXPECT_EQ(through(sensor, 0.0).x, 0.0);
    EXPECT_EQ(through(sensor, -1.0).x, 0.0);
    EXPECT_EQ(through(sensor, 1.0).x, 1.0);
}

TEST(SensorParts, Rec709AgainstItsRecommendation)
{
    Sensor sensor = nothing();
    sensor.encoding = {true, EncodingKind::Rec709};
    for (const double L : {0.0, 0.01, 0.0179, 0.0181, 0.18, 0.5, 1.0}) {
        const double single = double{static_cast<float>(L)};
        const double V = single >= 0.018 ? 1.099 * std::exp(0.45 * std::log(single)) - 0.099 : 4.5 * single;
        EXPECT_NEAR(through(sensor, L).x, V, 1e-15); // two roundings more in exp(log)
        // The recommendation's two pieces meet to 3e-4 / 4.5 only.
        EXPECT_NEAR(decodeRec709(through(sensor, L).x), single, 1e-4);
    }
    // 18 % grey is at 0.409: the value printed in BT.709 primers (8 bits, studio range: 105.6).
    EXPECT_NEAR(16.0 + 219.0 * through(sensor, 0.18).x, 105.6, 0.05);
}

TEST(SensorParts, QuantisesToEveryNumberOfBits)
{
    for (int bits = 1; bits <= 16; ++bits) {
        Sensor sensor = nothing();
        sensor.quantisation = {true, bits, false};
        const double levels = std::ldexp(1.0, bits) - 1.0;
        for (const float value : {0.0F, 0.1F, 0.3F, 0.5F, 0.7F, 1.0F})
            EXPECT_EQ(through(sensor, value).x, std::floor(levels * double{value} + 0.5) / levels) << bits;
        EXPECT_EQ(isDeep(sensor), bits > 8);
    }
}

TEST(SensorParts, FewBitsAreSpreadOverAllOfAByte)
{
    Sensor sensor = nothing();
    sensor.quantisation = {true, 2, false};
    for (const auto& [value, code] : {std::pair{0.0, 0}, {0.3, 85}, {0.6, 170}, {1.0, 255}})
        EXPECT_EQ(develop(ofValue(1, 1, value), sensor).rgb[0], code);
}

TEST(SensorParts, SixteenBitsKeepAllCodes)
{
    Sensor sensor = nothing();
    sensor.quantisation.bits = 16;
    sensor.quantisation.on = true;
    Image ramp(256, 86);
    for (std::size_t i = 0; i < ramp.rgb.size(); ++i)
        ramp.rgb[i] = static_cast<float>(i % 65536) / 65535.0F;
    const Developed developed = develop(ramp, sensor);
    ASSERT_EQ(developed.deep.size(), ramp.rgb.size());
    for (std::size_t i = 0; i < ramp.rgb.size(); ++i)
        ASSERT_EQ(developed.deep[i], i % 65536);
}

TEST(SensorParts, LuminanceIsThatOfRec709)
{
    Sensor sensor = nothing();
    sensor.view.kind = SensorViewKind::Luminance;
    Image image(1, 1);
    image.rgb = {1.0F, 0.5F, 0.25F};
    EXPECT_NEAR(developedAt(image, 0, 0, sensor).y, 0.2126 + 0.5 * 0.7152 + 0.25 * 0.0722, 1e-16);
}

TEST(SensorParts, FalseColoursChangeEveryStop)
{
    Sensor sensor = nothing();
    sensor.view.kind = SensorViewKind::FalseColor;
    const auto colors = falseColors();
    const auto bandAt = [&](double value) {
        const Vec3d color = through(sensor, value);
        for (std::size_t band = 0; band < falseColorBands; ++band)
            if (color.x == double{colors[3 * band]} && color.y == double{colors[3 * band + 1]})
                return static_cast<int>(band);
        return -1;
    };
    EXPECT_EQ(bandAt(0.0), 0);
    EXPECT_EQ(bandAt(std::nan("")), 0);
    for (int stop = lowestStop; stop <= 2; ++stop) {
        // The weights of the luminance sum to 1 only up to a rounding: 1e-6 beside the edge.
        EXPECT_EQ(bandAt(std::ldexp(1.0 + 1e-6, stop)), stop - lowestStop + 1);
        EXPECT_EQ(bandAt(std::ldexp(1.0 - 1e-6, stop)), stop - lowestStop);
    }
    EXPECT_EQ(bandAt(1e9), static_cast<int>(falseColorBands) - 1);
}

TEST(SensorParts, MarksPaintWhatCannotBeShown)
{
    Sensor sensor;
    sensor.view.marks = true;
    const auto painted = [&](double value) {
        Image image = ofValue(8, 1, value);
        int count = 0;
        Sensor plain;
        for (int x = 0; x < 8; ++x)
            count += developedAt(image, x, 0, sensor) == developedAt(image, x, 0, plain) ? 0 : 1;
        return count;
    };
    EXPECT_EQ(painted(0.5), 0);
    EXPECT_EQ(painted(1.0), 0);
    EXPECT_EQ(painted(1.01), 3); // of 8 pixels in a row
    EXPECT_EQ(painted(-0.01), 3);
    EXPECT_EQ(painted(std::nan("")), 8);
    EXPECT_EQ(painted(INFINITY), 8);
}

TEST(SensorParts, PlantedFaults)
{
    // Each part, switched on with values that differ from its default, changes a picture; a chain that forgot one would not.
    Image image(4, 4);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = 0.02F * static_cast<float>(i);
    const auto usual = develop(image, Sensor()).rgb;
    for (const char* part :
         {"exposure=0.5", "camera=on:iso=200", "vignetting=cos4", "noise=900", "well=0.3", "balance=1,0.5,1",
          "response=gamma", "encoding=rec709", "encoding=linear", "quantisation=3", "quantisation=8:dither=on"}) {
        Sensor sensor;
        const auto set = setOnSensor(part, sensor);
        ASSERT_TRUE(set) << set.error().sentence();
        EXPECT_NE(develop(image, sensor).rgb, usual) << part;
    }
}

struct BadPart {
    const char* assignment;
    const char* sentence;
};

TEST(SensorParts, WhatIsWrongIsSaidAndChangesNothing)
{
    for (const auto& [assignment, sentence] :
         {BadPart{"noise", "write PART=VALUE"}, BadPart{"nose=3", "did you mean 'noise'"},
          BadPart{"exposure=17", "'17' is not a number in -16 .. 16"}, BadPart{"exposure=nan", "is not a number"},
          BadPart{"quantisation=17", "a whole number in 1 .. 16"}, BadPart{"quantisation=8:dither=yes", "on or off"},
          BadPart{"noise=on:sigma=3", "'sigma' is no key of noise; it has read, shot, full_well, seed"},
          BadPart{"noise=on:3", "'3' is no KEY=VALUE"}, BadPart{"encoding=srbg", "one of linear, srgb, rec709"},
          BadPart{"balance=1,2", "three numbers"}, BadPart{"balance=1,-1,1", "none negative"},
          BadPart{"balance=on:matrix=1,2,3", "nine numbers"}, BadPart{"response=curve", "needs its file"},
          BadPart{"response=curve:file=/nowhere.csv", "/nowhere.csv"}, BadPart{"camera=on:aperture=0", "0.5 .. 128"},
          BadPart{"well=0", "1e-06 .. 1000000"}}) {
        Sensor sensor;
        const auto set = setOnSensor(assignment, sensor);
        ASSERT_FALSE(set) << assignment;
        EXPECT_NE(set.error().sentence().find(sentence), std::string::npos) << set.error().sentence();
        EXPECT_EQ(sensor, Sensor());
    }
}

TEST(SensorParts, APartAloneLeavesExposureAndEncoding)
{
    Sensor sensor;
    sensor.exposure = 1.0;
    sensor.noise.on = sensor.vignetting.on = true;
    const Sensor alone = onlyPart(sensor, "noise");
    EXPECT_TRUE(alone.noise.on && alone.encoding.on && alone.exposes);
    EXPECT_FALSE(alone.vignetting.on || alone.well.on || alone.quantisation.on);
    EXPECT_EQ(onlyPart(Sensor(), "noise").noise.on, false) << "what is off stays off";
    ASSERT_TRUE(setOnSensor("all=off", sensor));
    EXPECT_EQ(through(sensor, 0.3F), Vec3d(double{0.3F}));
    EXPECT_FALSE(setOnSensor("all=on", sensor));
}

TEST(SensorParts, AFlagSetsTheFirstFieldOrNamedOnes)
{
    Sensor sensor;
    ASSERT_TRUE(setOnSensor("noise=8:seed=3:shot=off", sensor));
    EXPECT_TRUE(sensor.noise.on);
    EXPECT_EQ(sensor.noise.read, 8.0);
    EXPECT_EQ(sensor.noise.seed, 3);
    EXPECT_FALSE(sensor.noise.shot);
    ASSERT_TRUE(setOnSensor("noise=off", sensor));
    EXPECT_FALSE(sensor.noise.on);
    EXPECT_EQ(sensor.noise.read, 8.0) << "switched off, it keeps its values";
    ASSERT_TRUE(setOnSensor("camera=shutter=0.5", sensor));
    EXPECT_EQ(sensor.camera.shutter, 0.5);
    for (const char* name :
         {"exposure", "camera", "vignetting", "noise", "well", "balance", "response", "encoding", "quantisation"})
        EXPECT_NE(sensorGrammar().find(name), std::string::npos);
}

} // namespace
} // namespace reflectance
