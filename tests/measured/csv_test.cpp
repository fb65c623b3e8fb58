// Tables in CSV: what the header may say, and that what is written comes back.
#include "core/base/text.h"
#include "core/measured/write.h"
#include "tests/measured/made_files.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>
#include <random>

namespace reflectance::testing {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Csv, ReadsTheLecturesTable)
{
    const Table scalar = table("# the lecture's\ntheta_i_deg,theta_r_deg,f\n0,0,0.1\n0,90,0.2\n60,0,0.3\n60,90,0.4\n");
    EXPECT_EQ(scalar.system, AngleSystem::Polar);
    EXPECT_EQ(scalar.axes[0], (std::vector<double>{0.0, 60.0 * pi / 180.0}));
    EXPECT_EQ(scalar.axes[1].back(), pi / 2.0) << "a right angle is one to the bit";
    EXPECT_EQ(scalar.values, (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
    const Table matrix = table("theta_i_deg,theta_r_deg,f_11,f_12,f_13,f_21,f_22,f_23,f_31,f_32,f_33\r\n"
                               "0,0,1,2,3,4,5,6,7,8,9\r\n");
    EXPECT_EQ(brdfAt(matrix, Vec3d(0, 0, 1), Vec3d(0, 0, 1))->rows[1], Vec3d(4, 5, 6)) << "row by row";
}

TEST(Csv, ColumnsMayStandInAnyOrder)
{
    const Table straight = table("theta_i_rad,theta_r_rad,delta_phi_rad,f\n0,0,0,1\n0,0,1,2\n0,1,0,3\n0,1,1,4\n"
                                 "1,0,0,5\n1,0,1,6\n1,1,0,7\n1,1,1,8\n");
    const Table turned = table("f,delta_phi_rad,theta_r_rad,theta_i_rad\n1,0,0,0\n5,0,0,1\n3,0,1,0\n7,0,1,1\n"
                               "2,1,0,0\n6,1,0,1\n4,1,1,0\n8,1,1,1\n");
    EXPECT_EQ(turned.values, straight.values);
    EXPECT_EQ(turned.axes, straight.axes);
}

TEST(Csv, DividesOutWhatTheQuantityHolds)
{
    const auto valueOf = [](const std::string& quantity) {
        return table("theta_i_deg,theta_r_deg," + quantity + "\n60,45,0.25\n").values.front();
    };
    EXPECT_EQ(valueOf("f"), 0.25);
    EXPECT_EQ(valueOf("f_r"), 0.25) << "as many write the BRDF";
    // One division, and the rounding of the cosine.
    EXPECT_NEAR(valueOf("f_cos_i"), 0.5, 1e-15);
    EXPECT_NEAR(valueOf("f_cos_r"), 0.25 * std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(valueOf("factor"), 0.5 / pi, 1e-15);
    EXPECT_NEAR(valueOf("relative"), 0.25 / pi, 1e-16);
    const Table rim = table("theta_i_deg,theta_r_deg,factor\n0,0,1\n90,0,0\n");
    EXPECT_EQ(rim.provenance.holes, 1U) << "0 / 0 at the horizon tells nothing";
}

TEST(Csv, CountsHolesAndNegativesAndKeepsThem)
{
    const Table t = table("theta_i_deg,theta_r_deg,f_red,f_green,f_blue\n0,0,1,-1,1\n0,30,1,nan,1\n0,60,-1,-1,-1\n");
    EXPECT_EQ(t.provenance.samples, 3U);
    EXPECT_EQ(t.provenance.holes, 1U);
    EXPECT_EQ(t.provenance.negatives, 2U);
    EXPECT_EQ(t.values[1], -1.0);
    EXPECT_TRUE(std::isnan(t.values[3])) << "one channel unmeasured: the sample is a hole";
}

TEST(Csv, AFullTurnClosesAndAHalfTurnMirrors)
{
    std::string text = "theta_i_deg,theta_r_deg,delta_phi_deg,f\n";
    for (int phi = 0; phi < 360; phi += 90)
        text += "0,0," + std::to_string(phi) + "," + std::to_string(phi) + "\n";
    const Table around = table(text);
    EXPECT_EQ(around.axes[2].size(), 5U);
    EXPECT_NEAR((*valueAt(around, {0, 0, -pi / 4.0}))[0], 135.0, 1e-12) << "between 270 and 360, which is 0";
}

Table randomTable(AngleSystem system, std::size_t channels, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Table t;
    t.system = system;
    t.channels = channels;
    t.interpolation = Interpolation::MonotoneCubic;
    t.provenance.name = "random";
    for (std::size_t axis = 0; axis < angleNames(system).size(); ++axis) {
        t.axes.emplace_back();
        for (int i = 0; i < 4; ++i)
            t.axes.back().push_back((i + unit(random)) / 4.0 * largestAngle(system, axis));
        t.axes.back().back() = largestAngle(system, axis);
    }
    std::size_t samples = 1;
    for (const auto& axis : t.axes)
        samples *= axis.size();
    for (std::size_t i = 0; i < samples; ++i)
        for (std::size_t c = 0; c < channels; ++c)
            t.values.push_back(i == 5 ? std::nan("") : std::ldexp(unit(random) - 0.25, static_cast<int>(i) - 20));
    return t;
}

/// To the bit, holes and negatives included; NaN is equal to nothing, so holes are compared apart.
void expectSame(const Table& a, const Table& b)
{
    EXPECT_EQ(a.axes, b.axes);
    EXPECT_EQ(a.system, b.system);
    ASSERT_EQ(a.values.size(), b.values.size());
    for (std::size_t i = 0; i < a.values.size(); ++i)
        EXPECT_TRUE(a.values[i] == b.values[i] || (std::isnan(a.values[i]) && std::isnan(b.values[i]))) << i;
}

TEST(Csv, ComesBackToTheBit)
{
    for (const AngleSystem system : {AngleSystem::Polar, AngleSystem::Isotropic, AngleSystem::HalfDifference})
        for (const std::size_t channels : {1U, 3U, 9U}) {
            const Table written = randomTable(system, channels, channels);
            const Table read = table(csvText(written));
            expectSame(written, read);
            EXPECT_EQ(read.interpolation, written.interpolation);
            EXPECT_EQ(read.provenance.name, "random");
        }
}

TEST(OpenMaterial, ComesBackToTheBit)
{
    for (const AngleSystem system : {AngleSystem::Polar, AngleSystem::Isotropic})
        for (const std::size_t channels : {1U, 3U}) {
            const Table written = randomTable(system, channels, 7 + channels);
            const std::string text = openMaterialText(written);
            EXPECT_THAT(text, ::testing::HasSubstr("1.570796,")) << "the standard's limit is rounded down";
            expectSame(written, table(text));
        }
}

TEST(Csv, ScatteredRowsNeedNoOrder)
{
    const Measurement scattered = measured("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,f\n30,0,30,180,0.5\n"
                                           "10,0,20,90,0.5\n50,20,5,-300,0.5\n40,0,40,0,0.5\n20,0,70,100,0.5\n");
    EXPECT_EQ(provenanceOf(scattered).samples, 5U);
    EXPECT_NEAR(brdfAt(scattered, directionAt(0.5, 1.0), directionAt(0.5, 1.0 + pi))->rows[0].x, 0.5, 1e-15);
}

} // namespace
} // namespace reflectance::testing
