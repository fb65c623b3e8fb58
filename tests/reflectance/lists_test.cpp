// Lists of numbers: a text that declares them, how many count, and what is said when they do not fit.
#include "core/reflectance/lists.h"

#include <gtest/gtest.h>

namespace reflectance {
namespace {

constexpr const char* head = "uniform int order = 1;\n//: choices 1 3\n"
                             "uniform float a[4] = float[](0.5, 0.25);\n//: legal -2 .. 2\n";
constexpr const char* names = "//: names order=1 x y\n//: names order=3 x z\n//: names order=3 y w\n";
constexpr const char* tail = "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return a[0] * I; }\n";

ModelText listed()
{
    auto model = parseModelText("listed", std::string(head) + names + tail, {});
    EXPECT_TRUE(model) << model.error().sentence();
    return *std::move(model);
}

TEST(Lists, AreDeclaredWithTheirForms)
{
    const ModelText model = listed();
    const Parameter& a = *model.find("a");
    EXPECT_EQ(model.valueCount(), 5U);
    EXPECT_EQ(a.size, 4U);
    EXPECT_EQ(a.initial, (std::vector<double>{0.5, 0.25}));
    ASSERT_EQ(a.forms.size(), 2U);
    EXPECT_EQ(a.forms[1].names, (std::vector<std::string>{"x", "z", "y", "w"}));
    EXPECT_EQ(model.find("order")->choices, (std::vector<double>{1, 3}));
}

TEST(Lists, AreFilledUpInTheFlatListOfValues)
{
    const ModelText model = listed();
    EXPECT_EQ(flatValues(model, {}), (std::vector<double>{1, 0.5, 0.25, 0, 0}));
    EXPECT_EQ(flatValues(model, {{"order", {3}}, {"a", {1, 2, 3, 4}}}), (std::vector<double>{3, 1, 2, 3, 4}));
    // A list that does not fit its choice counts as not named: the default, in the choice's form.
    EXPECT_EQ(flatValues(model, {{"order", {3}}, {"a", {1, 2}}}), (std::vector<double>{3, 0.5, 0, 0.25, 0}));
    const ParameterValues back = valuesByName(model, std::vector<double>{1, 0.5, 0.25, 7, 7});
    EXPECT_EQ(back.at("a"), (std::vector<double>{0.5, 0.25}));
}

TEST(Lists, ChangeFormByTheNamesOfTheirNumbers)
{
    const ModelText model = listed();
    const Parameter& a = *model.find("a");
    EXPECT_EQ(inForm(a, std::vector<double>{1, 2}, a.forms[1]), (std::vector<double>{1, 0, 2, 0}));
    EXPECT_EQ(inForm(a, std::vector<double>{1, 2, 3, 4}, a.forms[0]), (std::vector<double>{1, 3}));
    EXPECT_EQ(inForm(a, std::vector<double>{1, 2, 3}, a.forms[0]), (std::vector<double>{0, 0}));
}

TEST(Lists, AreRefusedByCountChoiceAndRange)
{
    const ModelText model = listed();
    const auto refusal = [&](const char* assignment) {
        ParameterValues values;
        const auto set = setParameter(model, assignment, values);
        return set ? std::string() : set.error().message;
    };
    EXPECT_EQ(refusal("a=1 2 1 2"), "");
    EXPECT_EQ(refusal("a=1 2 1"), "parameter a takes 2 or 4 numbers, not 3");
    EXPECT_EQ(refusal("a=1 9"), "parameter a = 9 is out of range; give a value in -2 .. 2");
    EXPECT_EQ(refusal("order=2"), "parameter order = 2 is not among its choices; give 1 or 3");
    EXPECT_EQ(refusal("order=1.5"), "parameter order = 1.5 is not among its choices; give 1 or 3");
}

TEST(Lists, MustAgreeWithTheirChoice)
{
    const ModelText model = listed();
    EXPECT_TRUE(checkLists(model, {}));
    EXPECT_TRUE(checkLists(model, {{"order", {3}}, {"a", {1, 2, 3, 4}}}));
    const auto refused = checkLists(model, {{"a", {1, 2, 3, 4}}});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "parameter a holds 4 numbers, and order = 1 takes 2; set both so that they agree");
    EXPECT_FALSE(checkLists(model, {{"order", {3}}}));
}

struct BadList {
    std::string text;
    const char* sentence;
};

class BadLists : public testing::TestWithParam<BadList> {};

TEST_P(BadLists, AreRefusedInTheText)
{
    const auto model = parseModelText("bad", GetParam().text + tail, {});
    ASSERT_FALSE(model);
    EXPECT_NE(model.error().sentence().find(GetParam().sentence), std::string::npos) << model.error().sentence();
}

INSTANTIATE_TEST_SUITE_P(
    Lists, BadLists,
    testing::Values(BadList{"uniform int k = 1;\n", "default of k is not among its choices"},
                    BadList{"uniform int k = 1;\n//: choices 2 3\n", "default of k is not among its choices"},
                    BadList{"uniform int k = 1;\n//: choices 3 1\n", "ascending"},
                    BadList{"uniform int k = 1;\n//: choices 1.5\n", "choices WHOLE"},
                    BadList{"uniform float a[0] = float[](1.0);\n", "NAME[COUNT]"},
                    BadList{"uniform float a[1] = float[](1.0, 2.0);\n", "more numbers in the default"},
                    BadList{"uniform float a[2] = float[](1.0);\n", "needs one line"},
                    BadList{std::string(head) + "//: names order=1 x y\n", "for each choice"},
                    BadList{std::string(head) + "//: names n=1 x y\n", "the choice standing above"},
                    BadList{std::string(head) + "//: names order=1 x\n//: names order=3 x y z w\n",
                            "does not hold what"},
                    BadList{std::string(head) + "//: names order=1 x y z w v\n", "more names than"}));

} // namespace
} // namespace reflectance
