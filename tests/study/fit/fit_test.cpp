// A fit must find the numbers that made its data, and say rightly how far it may be off.
#include "core/study/fit/fit.h"
#include "tests/study/fit/synthetic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace reflectance;
using testing::HasSubstr;

namespace {

const Model& model(const std::string& id)
{
    return **findModel(id);
}

const FittedNumber& number(const FitResult& fit, const std::string& name)
{
    for (const FittedNumber& n : fit.numbers)
        if (n.name == name)
            return n;
    throw std::runtime_error("no number " + name);
}

struct Truth {
    std::string model;
    ParameterValues values;
    std::vector<std::pair<std::string, double>> numbers; ///< as the fit of grey data names them
};

const std::vector<Truth>& truths()
{
    static const std::vector<Truth> all{
        {"oren_nayar", {{"rho", {0.6, 0.6, 0.6}}, {"sigma", {0.45}}}, {{"rho", 0.6}, {"sigma", 0.45}}},
        {"hybrid",
         {{"K", {0.4, 0.0, 0.0, 0.0, 0.4, 0.0, 0.0, 0.0, 0.4}}, {"ks", {0.3}}, {"n", {25.0}}},
         {{"K", 0.4}, {"ks", 0.3}, {"n", 25.0}}},
    };
    return all;
}

/// Per number of the truth: in how many of `trials` fits it lies within `errors` standard errors.
std::vector<int> hits(const Truth& truth, int trials, double errors)
{
    std::vector<int> found(truth.numbers.size(), 0);
    FitOptions options;
    options.starts = 2;
    for (int trial = 0; trial < trials; ++trial) {
        const Table table = synthetic({truth.model, truth.values, 0.02, static_cast<std::uint64_t>(trial) + 1, 1, {}});
        const auto fit = fitModel(model(truth.model), observationsOf(table), options);
        if (!fit)
            throw std::runtime_error(fit.error().sentence());
        for (std::size_t i = 0; i < found.size(); ++i) {
            const FittedNumber& n = number(*fit, truth.numbers[i].first);
            found[i] += std::fabs(n.value - truth.numbers[i].second) <= errors * n.standardError ? 1 : 0;
        }
    }
    return found;
}

/// Within 2 standard errors lie 95.45 % of normal draws. The count of `trials` then spreads by sqrt(trials p (1-p)); four of
/// that are met by chance once in 16 000 counts, and the seeds are fixed.
bool isTwoSigmaShare(int found, int trials)
{
    const double p = std::erf(std::sqrt(2.0));
    return std::fabs(found - p * trials) <= 4.0 * std::sqrt(trials * p * (1.0 - p));
}

} // namespace

TEST(Fit, FindsItsOwnParametersWithinTwoStandardErrorsAsOftenAsItSays)
{
    constexpr int trials = 200;
    for (const Truth& truth : truths()) {
        const std::vector<int> found = hits(truth, trials, 2.0);
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_TRUE(isTwoSigmaShare(found[i], trials))
                << truth.numbers[i].first << ": " << found[i] << " of " << trials;
    }
}

TEST(Fit, PlantedFaultErrorsOfHalfTheSizeAreCaught)
{
    constexpr int trials = 200;
    for (const int found : hits(truths().front(), trials, 1.0))
        EXPECT_FALSE(isTwoSigmaShare(found, trials));
}

// Without noise only rounding is left: the model's values carry about 1e-15, the minimum is flat to its square root.
TEST(Fit, WithoutNoiseFindsTheNumbersThemselves)
{
    for (const Truth& truth : truths()) {
        const auto fit =
            fitModel(model(truth.model), observationsOf(synthetic({truth.model, truth.values, 0.0, 1, 1, {}})));
        ASSERT_TRUE(fit);
        for (const auto& [name, value] : truth.numbers)
            EXPECT_NEAR(number(*fit, name).value, value, 1e-6 * value) << truth.model << ' ' << name;
        EXPECT_LT(fit->relativeRms, 1e-7);
        EXPECT_GE(fit->startsThatAgree, 1);
    }
}

TEST(Fit, ColoursGetANumberPerChannelAndShapesOneForAll)
{
    const ParameterValues values{{"rho", {0.7, 0.4, 0.2}}, {"sigma", {0.3}}};
    const auto fit = fitModel(model("oren_nayar"), observationsOf(synthetic({"oren_nayar", values, 0.0, 1, 3, {}})));
    ASSERT_TRUE(fit);
    ASSERT_EQ(fit->numbers.size(), 4U);
    EXPECT_NEAR(number(*fit, "rho red").value, 0.7, 1e-6);
    EXPECT_NEAR(number(*fit, "rho blue").value, 0.2, 1e-6);
    EXPECT_NEAR(number(*fit, "sigma").value, 0.3, 1e-6);
    FitOptions grey;
    grey.grey = {"rho"};
    const auto one =
        fitModel(model("oren_nayar"), observationsOf(synthetic({"oren_nayar", values, 0.0, 1, 3, {}})), grey);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->numbers.size(), 2U);
    EXPECT_GT(one->relativeRms, 0.1);
}

TEST(Fit, AMatrixTableGivesAllNineNumbersOfK)
{
    const std::vector<double> K{0.6, 0.1, 0.02, -0.05, 0.4, 0.03, 0.01, 0.2, 0.3};
    const auto fit =
        fitModel(model("lambert_color"), observationsOf(synthetic({"lambert_color", {{"K", K}}, 0.0, 1, 9, {}})));
    ASSERT_TRUE(fit);
    ASSERT_EQ(fit->numbers.size(), 9U);
    for (std::size_t i = 0; i < 9; ++i)
        EXPECT_NEAR(fit->numbers[i].value, K[i], 1e-9); // linear: one step, and rounding
}

TEST(Fit, ListsAreTurnedAsTheirChoiceSays)
{
    const std::vector<double> a{1.2, 0.2, -0.1, 0.3, 0.1};
    const ParameterValues values{{"order", {2.0}}, {"coefficients", a}};
    FitOptions order2;
    order2.fixed["order"] = {2.0};
    const auto fit =
        fitModel(model("koenderink"), observationsOf(synthetic({"koenderink", values, 0.0, 1, 1, {}})), order2);
    ASSERT_TRUE(fit);
    ASSERT_EQ(fit->numbers.size(), 5U);
    ASSERT_EQ(fit->values.at("coefficients").size(), 5U);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(fit->values.at("coefficients")[i], a[i], 1e-9); // linear, as above
    EXPECT_EQ(fit->numbers[4].name, "coefficients l2_n2_m2");
}

TEST(Fit, AFixedParameterKeepsItsValue)
{
    FitOptions options;
    options.fixed["n"] = {7.0};
    const auto fit =
        fitModel(model("hybrid"), observationsOf(synthetic({"hybrid", truths()[1].values, 0.0, 1, 1, {}})), options);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->numbers.size(), 2U);
    EXPECT_EQ(fit->values.at("n"), std::vector<double>{7.0});
}

TEST(Fit, StaysWithinLegalRangesAndSaysSo)
{
    // A table darker towards grazing angles than Lambert asks for a negative sigma, which the model does not have.
    Table table = synthetic({"lambert", {{"kd", {0.5}}}, 0.0, 1, 1, {}});
    std::size_t sample = 0;
    for (const double thetaI : table.axes[0])
        for (const double thetaR : table.axes[1])
            for (std::size_t k = 0; k < table.axes[2].size(); ++k)
                table.values[sample++] *= std::cos(thetaI) * std::cos(thetaR);
    const auto fit = fitModel(model("oren_nayar"), observationsOf(table));
    ASSERT_TRUE(fit);
    EXPECT_GE(number(*fit, "sigma").value, 0.0);
    EXPECT_LT(number(*fit, "sigma").value, 1e-5);
    EXPECT_TRUE(number(*fit, "sigma").atBound);
    EXPECT_THAT(testing::PrintToString(fit->warnings), HasSubstr("sigma lies at its lower bound"));
}

TEST(Fit, WeightsAndCosineChangeWhatIsMadeSmallNotWhatIsTrue)
{
    const Observations data = observationsOf(synthetic({"hybrid", truths()[1].values, 0.0, 1, 1, {}}));
    for (const Weighting weighting : {Weighting::Linear, Weighting::Logarithmic})
        for (const bool cosine : {false, true}) {
            FitOptions options;
            options.weighting = weighting;
            options.cosine = cosine;
            const auto fit = fitModel(model("hybrid"), data, options);
            ASSERT_TRUE(fit);
            EXPECT_NEAR(number(*fit, "n").value, 25.0, 1e-4);
        }
}

TEST(Fit, ARobustFitDoesNotFollowAnOutlier)
{
    Table table = synthetic({"lambert", {{"kd", {0.5}}}, 0.01, 1, 1, {}});
    table.values[100] = 30.0;
    const Observations data = observationsOf(table);
    FitOptions robust;
    robust.robust = true;
    const auto plain = fitModel(model("lambert"), data);
    const auto held = fitModel(model("lambert"), data, robust);
    ASSERT_TRUE(plain && held);
    EXPECT_GT(std::fabs(number(*plain, "kd").value - 0.5), 0.1);
    EXPECT_NEAR(number(*held, "kd").value, 0.5, 0.002); // 4 times the 0.01 / sqrt(392) of one mean
}

TEST(Fit, BicPrefersTheModelThatMadeTheData)
{
    const Observations data = observationsOf(synthetic({"lambert", {{"kd", {0.5}}}, 0.02, 5, 1, {}}));
    EXPECT_LT(fitModel(model("lambert"), data)->bic, fitModel(model("hybrid"), data)->bic);
    const Observations shiny = observationsOf(synthetic({"hybrid", truths()[1].values, 0.02, 5, 1, {}}));
    EXPECT_GT(fitModel(model("lambert"), shiny)->bic, fitModel(model("hybrid"), shiny)->bic);
}

TEST(Fit, IsTheSameEveryTime)
{
    const Observations data = observationsOf(synthetic({"hybrid", truths()[1].values, 0.02, 5, 1, {}}));
    const auto a = fitModel(model("hybrid"), data);
    const auto b = fitModel(model("hybrid"), data);
    EXPECT_EQ(a->values, b->values);
    EXPECT_EQ(a->correlations, b->correlations);
}

TEST(Fit, RefusesWhatCannotBeFitted)
{
    Observations data = observationsOf(synthetic({"lambert", {}, 0.0, 1, 1, {}}));
    EXPECT_THAT(fitModel(model("mirror"), data).error().message, HasSubstr("no BRDF measures"));
    FitOptions fixed;
    fixed.fixed["kd"] = {0.5};
    EXPECT_THAT(fitModel(model("lambert"), data, fixed).error().message, HasSubstr("no parameter left"));
    Observations few = data;
    few.rows.resize(2);
    few.seen.resize(2);
    few.cosine.resize(2);
    EXPECT_THAT(fitModel(model("hybrid"), few).error().message, HasSubstr("3 unknowns, and synthetic gives 2 numbers"));
    data.seen[3].x = NAN;
    EXPECT_THAT(fitModel(model("lambert"), data).error().message, HasSubstr("not finite"));
}

TEST(Fit, StopsWhenAsked)
{
    Progress progress;
    progress.cancel = true;
    const auto fit = fitModel(model("hybrid"), observationsOf(synthetic({"hybrid", {}, 0.0, 1, 1, {}})), {}, &progress);
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().message, "stopped");
}
