// The forms of the lobe keep the bounds that they state, in every arithmetic.
#include "core/reflectance/lobe_form.h"

#include "core/math/counting.h"
#include "core/reflectance/evaluate.h"
#include "core/reflectance/kernel_tables.h"
#include "core/reflectance/lobe_table.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

constexpr std::size_t angles = 2000;

/// Viewers from the peak to the horizon and beyond, every other one within five widths of a lobe of exponent n.
std::vector<double> anglesFor(double n)
{
    std::vector<double> all{0.0, 1.57, 1.6};
    const double widest = std::fmin(1.57, 5.0 / std::sqrt(std::fmax(n, 1.0)));
    for (std::size_t i = 0; i < angles; ++i)
        all.push_back((i % 2 == 0 ? 1.57 : widest) * static_cast<double>(i) / angles);
    return all;
}

/// Light along N, so that R = N exactly and the lobe is cos(angle)^n.
std::vector<Observation> rowsAt(const std::vector<double>& at)
{
    std::vector<Observation> rows;
    for (const double angle : at)
        rows.push_back({{0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}, {{{0, 0, 1}, {1, 1, 1}, 0.0}}});
    return rows;
}

std::vector<Vec3d> lobes(double n, const Arithmetic& arithmetic, const std::vector<double>& at)
{
    const Model& phong = **findModel("phong");
    return evaluate(phong, flatValues(phong.text, {{"ks", {1.0}}, {"n", {n}}}), rowsAt(at), arithmetic);
}

double worstDifference(double n, const Arithmetic& arithmetic)
{
    const std::vector<double> at = anglesFor(n);
    const std::vector<Vec3d> values = lobes(n, arithmetic, at);
    double worst = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i)
        worst = std::fmax(worst, std::fabs(values[i].x - std::pow(std::fmax(0.0, std::cos(at[i])), n)));
    return worst;
}

/// What the rounding of a dot product does to its n-th power at most: the product is off by three units, n multiplies that,
/// and the lobe that is multiplied is at most 1. Conditioned and table lose less.
double rounding(double n, double unit)
{
    return 4.0 * (n + 4.0) * unit;
}

constexpr double exponents[] = {1.0,  1.3,  1.41, 1.42, 2.0,  2.8,  3.0,   5.0,    5.7, 8.0,
                                10.0, 12.0, 16.0, 30.0, 37.5, 64.0, 200.0, 1000.0, 1e4};

TEST(LobeForms, StayWithinTheBoundThatTheyState)
{
    constexpr std::pair<Precision, double> precisions[] = {
        {Precision::Double, 0x1p-53}, {Precision::Float, 0x1p-24}, {Precision::Simd, 0x1p-24}};
    for (const LobeFormFacts& facts : lobeForms())
        for (const double n : exponents)
            for (const auto& [precision, unit] : precisions) {
                if (!checkExponent(facts.form, n))
                    continue;
                EXPECT_LE(worstDifference(n, {precision, facts.form}), facts.bound(n) + rounding(n, unit))
                    << facts.name << ' ' << n << ' ' << nameOf(precision);
            }
}

/// A bound that is ten times what is met would say nothing.
TEST(LobeForms, MeetTheirBoundsSomewhere)
{
    for (const LobeForm form : {LobeForm::Truncated, LobeForm::Schlick, LobeForm::Table})
        for (const double n : {100.0, 200.0, 1000.0})
            EXPECT_GE(worstDifference(n, {Precision::Double, form}), 0.5 * factsOf(form).bound(n))
                << factsOf(form).name << ' ' << n;
}

/// The planted fault: one form held to another's bound.
TEST(LobeForms, AreCaughtWhenTheyMissABound)
{
    EXPECT_GT(worstDifference(200.0, {Precision::Double, LobeForm::Schlick}),
              factsOf(LobeForm::Truncated).bound(200.0));
    EXPECT_GT(worstDifference(200.0, {Precision::Double, LobeForm::Truncated}), factsOf(LobeForm::Table).bound(200.0));
    EXPECT_GT(worstDifference(200.0, {Precision::Double, LobeForm::Table}), rounding(200.0, 0x1p-53));
}

TEST(LobeForms, AreOneAtThePeakAndNothingBehindTheSurface)
{
    for (const LobeFormFacts& facts : lobeForms())
        for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd})
            for (const double n : {1.0, 8.0, 1e6}) {
                const auto values = lobes(n, {precision, facts.form}, {0.0, 1.6, 3.1});
                EXPECT_EQ(values[0], Vec3d(1.0)) << facts.name << ' ' << n;
                EXPECT_EQ(values[1], Vec3d()) << facts.name << ' ' << n;
                EXPECT_EQ(values[2], Vec3d()) << facts.name << ' ' << n;
            }
}

/// The narrower instruction set is tested even where the wider one serves.
TEST(LobeForms, AreTheSameInSse2)
{
    const Model& phong = **findModel("phong");
    const std::vector<double> values = flatValues(phong.text, {{"ks", {1.0}}, {"n", {64.0}}});
    Model narrow = phong;
    for (const LobeFormFacts& facts : lobeForms().subspan(1))
        for (Kernels& kernels : narrow.otherLobes)
            if (&kernels == &narrow.with(facts.form))
                kernels.lanes = lanesKernelsSse2().with(facts.form)[0]; // phong is the first model that calls the lobe
    for (const LobeFormFacts& facts : lobeForms().subspan(1)) {
        const auto rows = rowsAt(anglesFor(64.0));
        const auto wide = evaluate(phong, values, rows, {Precision::Simd, facts.form});
        const auto sse2 = evaluate(narrow, values, rows, {Precision::Simd, facts.form});
        for (std::size_t i = 0; i < rows.size(); ++i)
            ASSERT_NEAR(wide[i].x, sse2[i].x, rounding(64.0, 0x1p-24)) << facts.name;
    }
}

TEST(LobeForms, ChangeNothingWithoutALobe)
{
    const Model& lambert = **findModel("lambert");
    EXPECT_EQ(&lambert.with(LobeForm::Schlick), &lambert.with(LobeForm::Conditioned));
    for (const Model& model : catalogue())
        EXPECT_EQ(model.otherLobes.size(), model.text.usesLobe ? lobeForms().size() - 1 : 0U) << model.id();
}

TEST(LobeForms, AreListedInTheOrderOfTheEnumeration)
{
    for (std::size_t i = 0; i < lobeForms().size(); ++i)
        EXPECT_EQ(static_cast<std::size_t>(lobeForms()[i].form), i);
}

TEST(LobeForms, GoByNamesAndRefuseOthers)
{
    for (const LobeFormFacts& facts : lobeForms())
        EXPECT_EQ(lobeFormNamed(facts.name).value(), facts.form);
    EXPECT_EQ(lobeFormNamed("blinn").error().message,
              "the lobe has no form 'blinn'; give conditioned, power, squarings, truncated, schlick, table");
}

TEST(LobeForms, SayWhichExponentsTheyAreFor)
{
    EXPECT_TRUE(checkExponent(LobeForm::Squarings, 0.0));
    EXPECT_TRUE(checkExponent(LobeForm::Squarings, 1e7));
    EXPECT_FALSE(checkExponent(LobeForm::Squarings, 37.5));
    EXPECT_FALSE(checkExponent(LobeForm::Truncated, 0.5));
    EXPECT_TRUE(checkExponent(LobeForm::Conditioned, 0.5));
    EXPECT_NE(checkExponent(LobeForm::Schlick, 0.5).error().message.find("n is 0.5"), std::string::npos);
}

TEST(Counting, TakesThePowerOfTwoNearestInRatio)
{
    EXPECT_EQ(squaringsFor(1.0), 0);
    EXPECT_EQ(squaringsFor(1.5), 1);
    EXPECT_EQ(squaringsFor(2.8), 1);
    EXPECT_EQ(squaringsFor(11.2), 3);
    EXPECT_EQ(squaringsFor(11.4), 4);
    EXPECT_EQ(squaringsFor(1e7F), 4);
    EXPECT_EQ(wholeNumber(7.0), 7);
    EXPECT_EQ(wholeNumber(1e7F), 10'000'000);
}

TEST(LobeTables, StartAtThePeakAndEndAtNothing)
{
    for (const double n : {1.0, 12.0, 50.0, 1e7}) {
        const LobeTable<double> table = makeLobeTable(n);
        EXPECT_EQ(table.values.front(), 1.0);
        EXPECT_EQ(table.values.back(), 0.0);
        // exp(-12) is left where it is cut; with n = 12 it is cut where cos is 0.
        EXPECT_LE(table.values[255], 1e-5 + std::pow(0.01, n)) << n;
    }
}

} // namespace
} // namespace reflectance
