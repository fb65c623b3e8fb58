// The catalogue: every text complete, values by name, bad values refused by name, value and range.
#include "core/reflectance/catalogue.h"

#include <gtest/gtest.h>

namespace reflectance {
namespace {

const ModelText& textOf(const char* id)
{
    return (**findModel(id)).text;
}

TEST(Catalogue, EveryModelSaysWhatItIs)
{
    ASSERT_GE(catalogue().size(), 5U);
    for (const Model& model : catalogue()) {
        const ModelText& t = model.text;
        for (const std::string& text : {t.name, t.formula, t.citation, t.about, t.reciprocal.reason, t.passive.reason})
            EXPECT_FALSE(text.empty()) << t.id;
        for (const Parameter& p : t.parameters) {
            for (const std::string& text : {p.label, p.symbol, p.tooltip, p.source})
                EXPECT_FALSE(text.empty()) << t.id << "." << p.name;
            EXPECT_LT(p.sliderMin, p.sliderMax) << t.id << "." << p.name;
            EXPECT_LE(p.legalMin, p.sliderMin) << t.id << "." << p.name;
            EXPECT_GE(p.legalMax, p.sliderMax) << t.id << "." << p.name;
            EXPECT_TRUE(!p.logarithmic || p.sliderMin > 0.0) << t.id << "." << p.name;
            EXPECT_TRUE(checkedValue(p, p.initial)) << t.id << "." << p.name << ": its own default is refused";
        }
        EXPECT_TRUE(model.exact.shade && model.single.shade && model.lanes.shade) << t.id;
        EXPECT_EQ(model.exact.environment != nullptr, t.usesEnvironment) << t.id;
    }
}

TEST(Catalogue, KernelsStandInTheOrderOfTheTexts)
{
    // A light of 2 on a surface that faces light and viewer: each model gives its own factor.
    const double N[3] = {0, 0, 1}, light[3] = {2, 2, 2}, disc = 0.01;
    const auto factorOf = [&](const char* id, const char* assignment) {
        const Model& model = **findModel(id);
        ParameterValues values;
        EXPECT_TRUE(setParameter(model.text, assignment, values));
        double sum[3] = {0, 0, 0};
        const Vec3Array<const double> n{&N[0], &N[1], &N[2]};
        const Vec3Array<const double> I{&light[0], &light[1], &light[2]};
        model.exact.shade(flatValues(model.text, values).data(), {1, n, n, n, I, &disc, {&sum[0], &sum[1], &sum[2]}});
        return sum[0];
    };
    EXPECT_EQ(factorOf("lambert", "kd=0.25"), 0.5);
    EXPECT_EQ(factorOf("lambert_color", "K=0.5"), 1.0);
    EXPECT_EQ(factorOf("mirror", "reflectance=0.75"), 1.5);
    EXPECT_EQ(factorOf("phong", "ks=0.125"), 0.25);
    EXPECT_EQ(factorOf("hybrid", "K=0 1 0 0 0 0 0 0 0"), 2.0 + 2.0 * 0.25); // its default ks
}

TEST(Catalogue, ValuesOutliveAChangeOfModel)
{
    ParameterValues values;
    ASSERT_TRUE(setParameter(textOf("phong"), "n=123", values));
    ASSERT_TRUE(setParameter(textOf("lambert"), "kd=0.5", values));
    const ModelText& hybrid = textOf("hybrid");
    EXPECT_EQ(flatValues(hybrid, values)[hybrid.find("n")->offset], 123.0);
}

TEST(Catalogue, SpreadsShortFormsOverAMatrix)
{
    const Parameter& K = *textOf("hybrid").find("K");
    EXPECT_EQ(*checkedValue(K, std::vector<double>{2}), (std::vector<double>{2, 0, 0, 0, 2, 0, 0, 0, 2}));
    EXPECT_EQ(*checkedValue(K, std::vector<double>{1, 2, 3}), (std::vector<double>{1, 0, 0, 0, 2, 0, 0, 0, 3}));
    EXPECT_FALSE(checkedValue(K, std::vector<double>{1, 2}));
}

struct BadAssignment {
    const char* text;
    const char* sentence;
};

class BadAssignments : public testing::TestWithParam<BadAssignment> {};

TEST_P(BadAssignments, AreRefusedAndChangeNothing)
{
    ParameterValues values{{"n", {7.0}}};
    const auto set = setParameter(textOf("hybrid"), GetParam().text, values);
    ASSERT_FALSE(set);
    EXPECT_NE(set.error().message.find(GetParam().sentence), std::string::npos) << set.error().message;
    EXPECT_EQ(values, (ParameterValues{{"n", {7.0}}}));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, BadAssignments,
                         testing::Values(BadAssignment{"n", "NAME=VALUE"}, BadAssignment{"n=", "takes 1 number, not 0"},
                                         BadAssignment{"n=1 2", "takes 1 number, not 2"},
                                         BadAssignment{"n=-1", "n = -1 is out of range; give a value in 0 .. 1e+07"},
                                         BadAssignment{"n=1e30", "out of range"},
                                         BadAssignment{"n=nan", "out of range"}, BadAssignment{"n=inf", "out of range"},
                                         BadAssignment{"n=x", "'x' is not a number"},
                                         BadAssignment{"K=1,2,3,4", "1, 3 or 9 numbers, not 4"},
                                         BadAssignment{"kd=1", "has no parameter 'kd'; did you mean 'ks'"}));

} // namespace
} // namespace reflectance
