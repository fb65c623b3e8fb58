// The lookup that renderers share, in float, against the table's own evaluation in double.
#include "core/measured/table_lookup.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace reflectance::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Numbers of 0 .. 1 over uneven angles at least 0.1 rad apart; every ninth sample a hole where `holes` says so.
Table randomTable(AngleSystem system, std::size_t channels, Interpolation interpolation, bool holes)
{
    std::mt19937_64 engine(7);
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    Table table;
    table.system = system;
    table.channels = channels;
    table.interpolation = interpolation;
    std::size_t samples = 1;
    for (std::size_t axis = 0; axis < angleNames(system).size(); ++axis) {
        const double end = axis < 2 ? pi / 2 : pi;
        std::vector<double> angles{0.0};
        while (angles.back() + 0.3 < end)
            angles.push_back(angles.back() + 0.1 + 0.2 * uniform());
        angles.push_back(end);
        samples *= angles.size();
        table.axes.push_back(std::move(angles));
    }
    for (std::size_t i = 0; i < samples; ++i)
        for (std::size_t c = 0; c < channels; ++c)
            table.values.push_back(holes && i % 9 == 4 ? NAN : uniform());
    return table;
}

struct Pair {
    Vec3d N, L, V;
};

/// About any normal, both above the surface, and no angle to N, to H or between them below 3 degrees: at the poles an azimuth is
/// nothing but the rounding of the directions.
std::vector<Pair> pairs(std::size_t count)
{
    std::mt19937_64 engine(11);
    const auto direction = [&] {
        const auto one = [&] { return 2.0 * static_cast<double>(engine() >> 11) * 0x1p-53 - 1.0; };
        Vec3d v{one(), one(), one()};
        while (dot(v, v) > 1.0 || dot(v, v) < 0.01)
            v = {one(), one(), one()};
        return normalized(v);
    };
    std::vector<Pair> all;
    while (all.size() < count) {
        const Vec3d N = direction();
        const Vec3d L = direction();
        const Vec3d V = direction();
        const Vec3d H = normalized(L + V);
        const auto isApart = [](const Vec3d& a, const Vec3d& b) { return length(cross(a, b)) > 0.05; };
        if (dot(N, L) > 0.01 && dot(N, V) > 0.01 && isApart(N, L) && isApart(N, V) && isApart(N, H) && isApart(L, V))
            all.push_back({N, L, V});
    }
    return all;
}

struct Disagreement {
    double worst = 0.0;
    std::size_t holes = 0, holesApart = 0;
};

Disagreement disagreement(const Table& table, const TableTexels& texels)
{
    Disagreement found;
    const Vec3d I{1.0, 0.5, 0.25};
    for (const Pair& p : pairs(4000)) {
        const Vec3d truth = lookedUp(table, p.N, p.L, p.V, I);
        const Vec3d got(lookedUp(texels, Vec3f(p.N), Vec3f(p.L), Vec3f(p.V), Vec3f(I)));
        const bool isHole = isHoleAt(table, p.N, p.L, p.V);
        found.holes += isHole ? 1U : 0U;
        if (isHole != (got == Vec3d()))
            ++found.holesApart;
        else
            found.worst = std::max(found.worst, length(got - truth));
    }
    return found;
}

using Setting = std::tuple<AngleSystem, std::size_t, Interpolation>;
class Lookup : public testing::TestWithParam<Setting> {};

/// Directions rounded to float turn the angles by up to 2e-7, azimuths by that over the sine 0.05 of the angle to the pole:
/// 4e-6. Values run by up to 1 over 0.1 rad, three times as steep where cubic, on each axis; three numbers add up in a row.
constexpr double allowed = 3.0 * 3.0 * 4e-6 * 3.0 / 0.1;

TEST_P(Lookup, InFloatGivesWhatTheTableGivesInDouble)
{
    const auto [system, channels, interpolation] = GetParam();
    const Table table = randomTable(system, channels, interpolation, false);
    ASSERT_TRUE(checkedTable(table));
    const Disagreement found = disagreement(table, texelsOf(table));
    EXPECT_EQ(found.holes, 0U);
    if (interpolation == Interpolation::Nearest) // values jump; few pairs are that near to the middle between samples
        return;
    EXPECT_LE(found.worst, allowed);
}

TEST_P(Lookup, LeavesHolesOutInTheSameWay)
{
    const auto [system, channels, interpolation] = GetParam();
    const Table table = randomTable(system, channels, interpolation, true);
    const Disagreement found = disagreement(table, texelsOf(table));
    EXPECT_GT(found.holes, 100U);
    // Where holes have half of the weight to within the angles' rounding, either answer is right.
    EXPECT_LE(found.holesApart, 4U);
}

INSTANTIATE_TEST_SUITE_P(
    Measured, Lookup,
    testing::Combine(testing::Values(AngleSystem::Polar, AngleSystem::Isotropic, AngleSystem::HalfDifference),
                     testing::Values(1U, 3U, 9U),
                     testing::Values(Interpolation::Nearest, Interpolation::Linear, Interpolation::MonotoneCubic)));

/// The planted faults: another interpolation, and the azimuth read from the other side.
TEST(LookupTest, CatchesAnotherInterpolationAndAnotherOrderOfAxes)
{
    const Table table = randomTable(AngleSystem::Isotropic, 3, Interpolation::Linear, false);
    TableTexels cubic = texelsOf(table);
    cubic.interpolation = static_cast<int>(Interpolation::MonotoneCubic);
    EXPECT_GT(disagreement(table, cubic).worst, 10.0 * allowed);
    Table swapped = table;
    std::reverse(swapped.values.begin(), swapped.values.end());
    EXPECT_GT(disagreement(table, texelsOf(swapped)).worst, 10.0 * allowed);
}

/// cos^n(theta_r - theta_i) / pi in the plane of incidence.
Table lobeTable(double n, double h)
{
    Table table;
    std::vector<double> angles;
    for (double a = 0.0; a < pi / 2 + 0.5 * h; a += h)
        angles.push_back(std::min(a, pi / 2));
    table.axes = {angles, angles};
    for (const double i : angles)
        for (const double r : angles)
            table.values.push_back(std::pow(std::cos(r - i), n) / pi);
    return table;
}

double worstInPlane(const Table& table, double n)
{
    const TableTexels texels = texelsOf(table);
    double worst = 0.0;
    for (int i = 1; i < 90; ++i)
        for (int r = 1; r < 90; ++r) {
            const double a = (i + 0.37) * pi / 182, b = (r + 0.61) * pi / 182;
            const Vec3d L{std::sin(a), 0, std::cos(a)};
            const Vec3d V{-std::sin(b), 0, std::cos(b)};
            const double truth = std::pow(std::cos(b - a), n);
            const Vec3d up{0, 0, 1};
            worst = std::max(worst, std::fabs(pi * lookedUp(table, up, L, V, Vec3d(1.0)).x - truth));
            worst = std::max(
                worst, std::fabs(pi * double(lookedUp(texels, Vec3f(up), Vec3f(L), Vec3f(V), Vec3f(1.0F)).x) - truth));
        }
    return worst;
}

/// A lobe bends by n at most, so a linear step of h along two axes errs by 2 n h^2 / 8; float adds n^(1/2) times 1e-6.
TEST(LookupTest, ReturnsASampledLobeWithinTheErrorOfItsSteps)
{
    for (const double n : {1.0, 10.0, 40.0})
        for (const double degrees : {1.0, 3.0}) {
            const double h = degrees * pi / 180;
            EXPECT_LE(worstInPlane(lobeTable(n, h), n), n * h * h / 4 + 1e-5) << n << ' ' << degrees;
            // And no better than that by much: the bound says something.
            EXPECT_GT(worstInPlane(lobeTable(n, h), n), n * h * h / 40) << n << ' ' << degrees;
        }
}

TEST(LookupTest, GivesLambertBackToTheLastBits)
{
    Table table = lobeTable(0.0, pi / 18);
    EXPECT_LE(worstInPlane(table, 0.0), 4e-7); // pi f in float
    for (const Pair& p : pairs(100))
        EXPECT_NEAR(pi * lookedUp(table, p.N, p.L, p.V, Vec3d(1.0)).y, 1.0, 1e-15);
}

TEST(LookupTest, IsDarkBelowTheHorizonsAndAHoleBeyondTheMeasuredAngles)
{
    Table table = lobeTable(0.0, pi / 18);
    table.axes[0].back() = table.axes[1].back() = 80.0 * pi / 180 + 1e-6; // up to 80 degrees and no further
    table.axes[0].pop_back();
    table.axes[1].pop_back();
    table.values.assign(81, 1.0);
    ASSERT_TRUE(checkedTable(table));
    const Vec3d up{0, 0, 1};
    const Vec3d grazing = directionAt(85.0 * pi / 180, 0.0);
    const Vec3d steep = directionAt(0.5, 1.0);
    EXPECT_TRUE(isHoleAt(table, up, grazing, steep));
    EXPECT_TRUE(isHoleAt(table, up, steep, grazing));
    EXPECT_FALSE(isHoleAt(table, up, steep, steep));
    EXPECT_FALSE(isHoleAt(table, up, -steep, steep)) << "no light arrives there: that is no hole";
    EXPECT_EQ(lookedUp(texelsOf(table), Vec3f(up), Vec3f(grazing), Vec3f(steep), Vec3f(1.0F)), Vec3f());
    EXPECT_EQ(lookedUp(texelsOf(table), Vec3f(up), Vec3f(-steep), Vec3f(steep), Vec3f(1.0F)), Vec3f());
}

} // namespace
} // namespace reflectance::test
