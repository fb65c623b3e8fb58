// What a table promises between its samples, at its rim and at its holes.
#include "core/measured/table.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double hole = std::numeric_limits<double>::quiet_NaN();

/// Uneven axes with f(angles) in every channel c times (c + 1).
template <class F> Table tableOf(AngleSystem system, std::size_t channels, F f)
{
    Table table;
    table.system = system;
    table.channels = channels;
    table.axes = {{0.0, 0.1, 0.3, 0.7, pi / 2.0}, {0.0, 0.5, 0.6, 1.2}};
    if (system != AngleSystem::Polar)
        table.axes.push_back({0.0, 1.0, 1.5, pi});
    const std::vector<double> one{0.0};
    for (const double a : table.axes[0])
        for (const double b : table.axes[1])
            for (const double c : system == AngleSystem::Polar ? one : table.axes[2])
                for (std::size_t channel = 0; channel < channels; ++channel)
                    table.values.push_back(f(Angles{a, b, c}) * (1.0 + static_cast<double>(channel)));
    return table;
}

double multilinear(const Angles& a)
{
    return (1.0 + 2.0 * a[0]) * (3.0 - a[1]) * (1.0 + 0.5 * a[2]);
}

const Interpolation every[] = {Interpolation::Nearest, Interpolation::Linear, Interpolation::MonotoneCubic};

TEST(Table, GivesItsSamplesToTheBit)
{
    for (const AngleSystem system : {AngleSystem::Polar, AngleSystem::Isotropic, AngleSystem::HalfDifference})
        for (const std::size_t channels : {1U, 3U, 9U})
            for (const Interpolation interpolation : every) {
                Table table = tableOf(system, channels, multilinear);
                ASSERT_TRUE(checkedTable(table));
                table.interpolation = interpolation;
                const auto value = valueAt(table, {0.3, 0.6, 1.5});
                const double expected = multilinear({0.3, 0.6, system == AngleSystem::Polar ? 0.0 : 1.5});
                ASSERT_TRUE(value);
                for (std::size_t c = 0; c < channels; ++c)
                    EXPECT_EQ((*value)[c], expected * (1.0 + static_cast<double>(c)));
            }
}

TEST(Table, IsExactForWhatItsInterpolationAssumes)
{
    Table table = tableOf(AngleSystem::Isotropic, 3, multilinear);
    const Table straight = tableOf(AngleSystem::Isotropic, 1, [](const Angles& a) { return 2.0 - a[0]; });
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const Angles at{unit(random) * pi / 2.0, unit(random) * 1.2, unit(random) * pi};
        // Seven combinations of two numbers, each with four roundings.
        EXPECT_NEAR((*valueAt(table, at))[2], 3.0 * multilinear(at), 30e-15 * 3.0 * multilinear(at));
        Table cubic = straight;
        cubic.interpolation = Interpolation::MonotoneCubic;
        EXPECT_NEAR((*valueAt(cubic, at))[0], 2.0 - at[0], 1e-14) << "a straight line stays one";
    }
}

/// A step: the cubic never leaves the range of its samples, and is smoother than the straight line.
TEST(Table, CubicDoesNotOvershoot)
{
    Table table = tableOf(AngleSystem::Polar, 1, [](const Angles& a) { return a[0] < 0.2 ? 0.0 : 1.0; });
    table.interpolation = Interpolation::MonotoneCubic;
    double before = -1.0;
    for (double theta = 0.0; theta <= pi / 2.0; theta += 1e-3) {
        const double value = (*valueAt(table, {theta, 0.2, 0.0}))[0];
        EXPECT_GE(value, -1e-15); // the roundings of three products
        EXPECT_LE(value, 1.0 + 1e-15);
        EXPECT_GE(value, before - 1e-15) << "monotone at " << theta;
        before = value;
    }
    EXPECT_NEAR((*valueAt(table, {0.15, 0.2, 0.0}))[0], 0.15625, 1e-12) << "t = 1/4 with flat ends: t^2 (3 - 2t)";
}

TEST(Table, ExtrapolatesNothing)
{
    const Table table = tableOf(AngleSystem::Polar, 1, multilinear);
    EXPECT_TRUE(valueAt(table, {0.2, 1.2, 0.0}));
    EXPECT_TRUE(valueAt(table, {0.2, 1.2 + 1e-10, 0.0})) << "rounding of a direction";
    EXPECT_FALSE(valueAt(table, {0.2, 1.2001, 0.0}));
    EXPECT_FALSE(valueAt(table, {hole, 0.2, 0.0}));
    EXPECT_FALSE(brdfAt(table, directionAt(0.2, 0.0), directionAt(1.3, 0.0)));
    EXPECT_FALSE(brdfAt(table, directionAt(0.2, 0.0), Vec3d(1.0, 0.0, 0.0))) << "not above the surface";
    Table single = table;
    single.axes = {{pi / 4.0}, {0.0, 1.0}};
    single.values = {1.0, 3.0};
    EXPECT_NEAR((*valueAt(single, {pi / 4.0, 0.5, 0.0}))[0], 2.0, 1e-15);
    EXPECT_FALSE(valueAt(single, {pi / 4.0 + 0.01, 0.5, 0.0})) << "one angle of incidence tells nothing of others";
}

TEST(Table, HolesTakeNoPart)
{
    for (const Interpolation interpolation : every) {
        Table table = tableOf(AngleSystem::Polar, 3, [](const Angles& a) { return a[0] == 0.3 ? hole : 2.0; });
        table.interpolation = interpolation;
        for (double theta = 0.0; theta <= pi / 2.0; theta += 1e-3) {
            const auto value = valueAt(table, {theta, 0.4, 0.0});
            EXPECT_EQ(value.has_value(), theta <= 0.2 || theta >= 0.5) << theta;
            if (value) {
                EXPECT_NEAR((*value)[1], 4.0, 4e-15) << "no trace of the hole beside it";
            }
        }
    }
}

TEST(Table, FoldsAzimuthsAsFarAsItReaches)
{
    Table table = tableOf(AngleSystem::Isotropic, 1, [](const Angles& a) { return a[2]; });
    const Vec3d L = directionAt(0.5, 2.0);
    EXPECT_NEAR(brdfAt(table, L, directionAt(0.5, 3.0))->rows[0].x, 1.0, 1e-14);
    EXPECT_NEAR(brdfAt(table, L, directionAt(0.5, 1.0))->rows[0].x, 1.0, 1e-14) << "mirror-symmetric";
    table.axes[2].back() = 2.0 * pi;
    for (double& value : table.values)
        value = value > 3.0 ? 2.0 * pi : value;
    EXPECT_NEAR(brdfAt(table, L, directionAt(0.5, 3.0))->rows[0].x, 1.0, 1e-14);
    EXPECT_NEAR(brdfAt(table, L, directionAt(0.5, 1.0))->rows[0].x, 2.0 * pi - 1.0, 1e-14) << "all the way round";
}

TEST(Table, ChannelsAreAMatrix)
{
    const Channels values{1, 2, 3, 4, 5, 6, 7, 8, 9};
    const Vec3d I{1, 10, 100};
    EXPECT_EQ(matrixOf(values, 1) * I, Vec3d(1, 10, 100));
    EXPECT_EQ(matrixOf(values, 3) * I, Vec3d(1, 20, 300));
    EXPECT_EQ(matrixOf(values, 9) * I, Vec3d(321, 654, 987));
}

TEST(Table, ChecksFindEveryFlaw)
{
    const Table good = tableOf(AngleSystem::Polar, 3, multilinear);
    ASSERT_TRUE(checkedTable(good));
    const auto flawed = [&](auto damage) {
        Table table = good;
        damage(table);
        return !checkedTable(table);
    };
    EXPECT_TRUE(flawed([](Table& t) { t.channels = 2; }));
    EXPECT_TRUE(flawed([](Table& t) { t.values.pop_back(); }));
    EXPECT_TRUE(flawed([](Table& t) { t.axes.pop_back(); }));
    EXPECT_TRUE(flawed([](Table& t) { t.axes[0].clear(); }));
    EXPECT_TRUE(flawed([](Table& t) { t.axes[0][1] = t.axes[0][0]; }));
    EXPECT_TRUE(flawed([](Table& t) { std::swap(t.axes[0][1], t.axes[0][2]); }));
    EXPECT_TRUE(flawed([](Table& t) { t.axes[0].back() = 1.6; }));
    EXPECT_TRUE(flawed([](Table& t) { t.axes[0][0] = -0.1; }));
    EXPECT_TRUE(flawed([](Table& t) { t.axes[0][1] = hole; }));
}

} // namespace
} // namespace reflectance
