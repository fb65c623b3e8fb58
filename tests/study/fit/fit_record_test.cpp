// Fits as lines of text: nothing is lost on the way, and what is no such line is not taken for one.
#include "core/study/fit/fit_record.h"

#include <gtest/gtest.h>
#include <limits>

using namespace reflectance;

namespace {

FitResult aFit()
{
    FitResult fit;
    fit.values = {{"K", {0.1, 1e-300, -0.0}}, {"none", {}}};
    fit.numbers = {{"K red", 1.0 / 3.0, std::numeric_limits<double>::infinity(), true, false},
                   {"n", 40.0, 0.25, false, true}};
    fit.correlations = {1.0, -0.5, -0.5, 1.0};
    fit.rms = 0.125;
    fit.relativeRms = std::numeric_limits<double>::quiet_NaN();
    fit.weightedRms = 3.0;
    fit.aic = -1e5;
    fit.bic = -99999.5;
    fit.residuals = 12345;
    fit.startsTried = 8;
    fit.startsThatAgree = 3;
    fit.iterations = 17;
    fit.warnings = {"n rests on few samples", "K, red: at its bound"};
    return fit;
}

} // namespace

TEST(FitRecord, ReadsBackToTheSame)
{
    const FitResult fit = aFit();
    const std::string record = recordOf(fit);
    EXPECT_EQ(record.find('\n'), std::string::npos) << "one line";
    const auto read = fitFromRecord(record);
    ASSERT_TRUE(read);
    EXPECT_EQ(recordOf(*read), record);
    EXPECT_EQ(read->values, fit.values);
    ASSERT_EQ(read->numbers.size(), 2U);
    EXPECT_EQ(read->numbers[0].name, "K red");
    EXPECT_EQ(read->numbers[0].value, fit.numbers[0].value);
    EXPECT_TRUE(read->numbers[0].atBound);
    EXPECT_FALSE(read->numbers[0].determined);
    EXPECT_EQ(read->correlations, fit.correlations);
    EXPECT_TRUE(std::isnan(read->relativeRms));
    EXPECT_EQ(read->iterations, 17);
    EXPECT_EQ(read->warnings, fit.warnings);
}

/// The planted faults: every beginning of a record, and every field replaced.
TEST(FitRecord, DamageIsNotRead)
{
    const std::string record = recordOf(aFit());
    for (std::size_t length = 0; length < record.size(); ++length)
        if (record[length] == '\t') {
            EXPECT_FALSE(fitFromRecord(record.substr(0, length))) << record.substr(0, length);
        }
    EXPECT_FALSE(fitFromRecord(record + "\tmore"));
    EXPECT_FALSE(fitFromRecord("9" + record));
    EXPECT_FALSE(fitFromRecord("x" + record));
    EXPECT_FALSE(fitFromRecord(""));
}
