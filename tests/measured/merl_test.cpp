// MERL's binary: the places of its samples, its factors, its holes; and the albedo of a planted Lambertian file.
#include "core/measured/bytes.h"
#include "core/measured/facts.h"
#include "core/measured/write.h"
#include "tests/measured/made_files.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>
#include <random>

namespace reflectance::testing {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double scale[3] = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

Channels diagonal(const Mat3d& f)
{
    return {f.rows[0].x, f.rows[1].y, f.rows[2].z};
}

TEST(Merl, ScalesEachChannelByItsOwnFactor)
{
    const Table t = table(merlFile(2, 2, 3, {3.0, 3.0, 3.0}));
    EXPECT_EQ(t.system, AngleSystem::HalfDifference);
    EXPECT_EQ(t.provenance.samples, 12U);
    const Channels f = diagonal(*brdfAt(t, directionAt(0.3, 0.0), directionAt(1.0, 2.0)));
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(f[c], 3.0 * scale[c], 1e-18) << "without the factors, the picture is yellow";
}

/// 3 x 2 x 2 cells that hold their own number: phi_d runs fastest, then theta_d, then theta_h.
std::string numberedCells(double addend = 0.0)
{
    std::string bytes = merlFile(3, 2, 2, {});
    for (int channel = 0; channel < 3; ++channel)
        for (int cell = 0; cell < 12; ++cell)
            appendLittleEndian(bytes, cell + addend);
    return bytes;
}

TEST(Merl, PlacesSamplesAsTheFormatDoes)
{
    const Table t = table(numberedCells());
    const auto at = [&](double h, double d, double p) { return (*valueAt(t, {h, d, p}))[0] * 1500.0; };
    EXPECT_NEAR(at(0, 0, 0), 0.0, 1e-12);
    EXPECT_NEAR(at(0, 0, pi / 2.0), 1.0, 1e-12);
    EXPECT_NEAR(at(0, pi / 4.0, 0), 2.0, 1e-12);
    EXPECT_NEAR(at(pi / 18.0, 0, 0), 4.0, 1e-12) << "theta_h of sample 1 of 3 is (1/3)^2 of 90 degrees";
    EXPECT_NEAR(at(0, 0, pi), 0.0, 1e-12) << "phi_d = 180 is phi_d = 0";
    EXPECT_NEAR(at(pi / 2.0, pi / 2.0, 0), 10.0, 1e-12) << "the last sample holds for its cell";
}

TEST(Merl, NegativeNumbersAreHolesAndDoNotLeak)
{
    const Table t = table(numberedCells(-0.5)); // cell 0 is -0.5, cell 1 is 0.5
    EXPECT_EQ(t.provenance.holes, 1U);
    EXPECT_FALSE(valueAt(t, {0, 0, 0.1}));
    EXPECT_NEAR((*valueAt(t, {0, 0, pi / 3.0}))[0] * 1500.0, 0.5, 1e-12) << "nothing of -0.5 beside the hole";
}

/// The whole format: a file of f = 0.5/pi must reflect half of the light, whatever the direction.
TEST(Merl, APlantedLambertianFileHasAlbedoOneHalf)
{
    const double f = 0.5 / pi;
    const std::string bytes = merlFile(90, 90, 180, {f / scale[0], f / scale[1], f / scale[2]});
    ASSERT_EQ(bytes.size(), 34992012U);
    const Measurement m = measured(bytes);
    for (const double theta : {0.0, 0.4, 1.0, 1.5, 1.57}) {
        const Albedo albedo = albedoAt(m, theta);
        EXPECT_EQ(albedo.known, 1.0);
        // Sums of sums of some hundred equal numbers each, and the factor's two roundings.
        EXPECT_NEAR(albedo.value.x, 0.5, 1e-12);
        EXPECT_NEAR(albedo.value.y, 0.5, 1e-12);
        EXPECT_NEAR(albedo.value.z, 0.5, 1e-12);
    }
}

/// Values of which each is within a rounding of its own after a walk through the file.
TEST(Merl, WhatIsWrittenComesBack)
{
    Table written;
    written.system = AngleSystem::HalfDifference;
    written.channels = 3;
    const GridShape shape = naturalShape(TableFormat::Merl);
    written.axes = shape.axes;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (std::size_t i = 0; i < 3 * shape.samples(); ++i)
        written.values.push_back(unit(random));
    std::fill_n(written.values.begin() + 3 * 12345, 3, std::nan(""));
    const Table read = table(merlBytes(written));
    ASSERT_EQ(read.axes, written.axes);
    EXPECT_EQ(read.provenance.holes, 1U);
    EXPECT_EQ(merlBytes(read), merlBytes(written)) << "and a second time to the bit";
    std::size_t exact = 0;
    for (std::size_t h = 0; h < 90; ++h)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t at = (h * 91 * 181 + 17 * 181 + 5) * 3 + i;
            EXPECT_NEAR(read.values[at], written.values[at], 2e-16 * written.values[at]); // one unit of the last place
            exact += read.values[at] == written.values[at] ? 1 : 0;
        }
    EXPECT_GT(exact, 200U) << "nearly all of 270 to the bit; for the rest no 64-bit number times the factor is f";
}

} // namespace
} // namespace reflectance::testing
