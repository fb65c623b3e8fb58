// Noise and dither against the model that they state, with a fixed seed: the draws are always the same, so the bounds, five
// standard errors wide, are met or not once and for all.
#include "core/sensor/sensor.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

constexpr int side = 300; // 270,000 channels

struct Moments {
    double mean = 0.0, variance = 0.0, skew = 0.0;
    double neighbours = 0.0; ///< correlation along rows
    double channels = 0.0;   ///< between red and green
};

Image ofValue(double value)
{
    Image image(side, side);
    std::fill(image.rgb.begin(), image.rgb.end(), static_cast<float>(value));
    return image;
}

/// No rounding but that of 16 bits, 5e-6 as a standard deviation.
Sensor noisySensor(double read, bool shot, double fullWell, int seed = 1)
{
    Sensor sensor;
    sensor.noise = {true, shot, read, fullWell, seed};
    sensor.well.on = sensor.encoding.on = sensor.quantisation.on = false;
    return sensor;
}

Moments momentsOf(const Developed& developed)
{
    const auto at = [&](std::size_t i) { return developed.deep[i] / 65535.0; };
    const auto n = static_cast<double>(developed.deep.size());
    Moments m;
    for (std::size_t i = 0; i < developed.deep.size(); ++i)
        m.mean += at(i) / n;
    for (std::size_t i = 0; i < developed.deep.size(); ++i) {
        const double d = at(i) - m.mean;
        m.variance += d * d / n;
        m.skew += d * d * d / n;
        if (i >= 3)
            m.neighbours += d * (at(i - 3) - m.mean) / n;
        if (i % 3 == 1)
            m.channels += 3.0 * d * (at(i - 1) - m.mean) / n;
    }
    m.skew /= std::pow(m.variance, 1.5);
    m.neighbours /= m.variance;
    m.channels /= m.variance;
    return m;
}

class NoiseOf : public testing::TestWithParam<std::tuple<double, double, bool>> {};

TEST_P(NoiseOf, HasTheStatedMeanAndVariance)
{
    const auto [value, read, shot] = GetParam();
    const double fullWell = 20000.0;
    const Moments m = momentsOf(develop(ofValue(value), noisySensor(read, shot, fullWell)));
    const double single = double{static_cast<float>(value)};
    const double variance = (shot ? single / fullWell : 0.0) + read * read / (fullWell * fullWell);
    const double n = 3.0 * side * side;
    EXPECT_NEAR(m.mean, single, 5.0 * std::sqrt(variance / n));
    const double rounding = 1.0 / (12.0 * 65535.0 * 65535.0);
    EXPECT_NEAR(m.variance, variance + rounding, 5.0 * variance * std::sqrt(2.0 / n));
    EXPECT_NEAR(m.skew, 0.0, 5.0 * std::sqrt(6.0 / n));
    EXPECT_NEAR(m.neighbours, 0.0, 5.0 / std::sqrt(n));
    EXPECT_NEAR(m.channels, 0.0, 5.0 / std::sqrt(n / 3.0));
}

INSTANTIATE_TEST_SUITE_P(Levels, NoiseOf,
                         testing::Values(std::tuple{0.5, 0.0, true}, std::tuple{0.1, 20.0, true},
                                         std::tuple{0.5, 200.0, false}, std::tuple{0.9, 50.0, true}));

TEST(Noise, WouldNoticeAVarianceFivePercentOff)
{
    const Moments m = momentsOf(develop(ofValue(0.5), noisySensor(0.0, true, 20000.0 / 1.05)));
    const double stated = 0.5 / 20000.0;
    EXPECT_GT(std::fabs(m.variance - stated), 5.0 * stated * std::sqrt(2.0 / (3.0 * side * side)));
}

TEST(Noise, DependsOnPlaceAndSeedAlone)
{
    const Image image = ofValue(0.5);
    const Developed once = develop(image, noisySensor(5.0, true, 1000.0));
    EXPECT_EQ(once.deep, develop(image, noisySensor(5.0, true, 1000.0)).deep);
    EXPECT_NE(once.deep, develop(image, noisySensor(5.0, true, 1000.0, 2)).deep);
    // One pixel by itself has the noise that it has in the picture.
    const Vec3d alone = developedAt(image, 17, 211, noisySensor(5.0, true, 1000.0));
    EXPECT_EQ(once.deep[3 * (211 * side + 17)], static_cast<int>(std::floor(65535.0 * alone.x + 0.5)));
}

TEST(Noise, GrowsWithIso)
{
    Sensor sensor = noisySensor(0.0, true, 20000.0);
    sensor.camera.on = true;
    sensor.camera.iso = 1600.0;
    EXPECT_EQ(electronsAtWhite(sensor), 1250.0);
    sensor.exposure = -4.0; // as bright as at ISO 100, from a sixteenth of the electrons
    const double n = 3.0 * side * side;
    const Moments m = momentsOf(develop(ofValue(0.5), sensor));
    EXPECT_NEAR(m.variance, 0.5 / 1250.0, 5.0 * 0.5 / 1250.0 * std::sqrt(2.0 / n));
}

TEST(Dither, KeepsTheMeanThatRoundingLoses)
{
    Sensor sensor = noisySensor(0.0, false, 1.0);
    sensor.noise.on = false;
    sensor.quantisation = {true, 1, true};
    for (const double value : {0.1, 0.3, 0.77}) {
        const Developed dithered = develop(ofValue(value), sensor);
        double mean = 0.0;
        for (const std::uint8_t code : dithered.rgb) {
            EXPECT_TRUE(code == 0 || code == 255);
            mean += code / 255.0 / static_cast<double>(dithered.rgb.size());
        }
        // Bernoulli: variance p (1 - p) / n.
        EXPECT_NEAR(mean, value, 5.0 * std::sqrt(value * (1.0 - value) / (3.0 * side * side)));
    }
    sensor.quantisation.dither = false;
    EXPECT_EQ(develop(ofValue(0.3), sensor).rgb[0], 0) << "without it the mean is lost";
}

TEST(Dither, LeavesWhatIsALevelAlone)
{
    Sensor sensor;
    sensor.encoding.on = false;
    sensor.quantisation = {true, 4, true};
    for (const double value : {0.0, 1.0})
        for (const std::uint8_t code : develop(ofValue(value), sensor).rgb)
            ASSERT_EQ(code, value == 0.0 ? 0 : 255);
}

} // namespace
} // namespace reflectance
