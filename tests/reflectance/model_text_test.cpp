// The parser of model texts: what it takes from a good one, and where it points in a bad one.
#include "core/reflectance/model_text.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

constexpr const char* good = R"(//! name Example
//! reciprocal no: it is an example
uniform float a = 0.25;
//: label   First
//: slider  1 .. 100 log
//: legal   0 .. 1e7
uniform mat3 K = transpose(mat3(1, 2, 3,
                                4, 5, 6,
                                7, 8, 9));
uniform vec3 f0 = vec3(0.04);
vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return a * I * insideLight(L, V); }
)";

TEST(ModelText, TakesParametersWithTheirDescription)
{
    const auto model = parseModelText("example", good, {});
    ASSERT_TRUE(model) << model.error().sentence();
    EXPECT_EQ(model->name, "Example");
    EXPECT_FALSE(model->reciprocal.holds);
    ASSERT_EQ(model->parameters.size(), 3U);
    const Parameter& a = model->parameters[0];
    EXPECT_EQ(a.label, "First");
    EXPECT_TRUE(a.logarithmic);
    EXPECT_EQ(a.sliderMax, 100.0);
    EXPECT_EQ(a.legalMax, 1e7);
    EXPECT_EQ(model->parameters[1].initial, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(model->parameters[2].initial, (std::vector<double>{0.04, 0.04, 0.04}));
    EXPECT_EQ(model->parameters[2].offset, 10U);
    EXPECT_EQ(model->valueCount(), 13U);
    EXPECT_TRUE(model->usesLightSize);
    EXPECT_FALSE(model->usesEnvironment);
}

TEST(ModelText, KeepsTheLineNumbersOfTheCode)
{
    const auto model = parseModelText("example", good, {});
    ASSERT_TRUE(model);
    const std::size_t at = model->code.find("vec3 shade(");
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(std::count(model->code.begin(), model->code.begin() + static_cast<long>(at), '\n'), 10);
    EXPECT_EQ(model->code.find("uniform"), std::string::npos);
}

TEST(ModelText, TakesADescriptionOverFromAnEarlierModel)
{
    std::vector<ModelText> earlier{*parseModelText("example", good, {})};
    const std::string text = std::string("uniform float a = 0.75;\n//: like example\n") +
                             "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return I; }\n";
    const auto model = parseModelText("second", text, earlier);
    ASSERT_TRUE(model) << model.error().sentence();
    EXPECT_EQ(model->parameters[0].label, "First");
    EXPECT_EQ(model->parameters[0].initial, std::vector<double>{0.75});
}

TEST(ModelText, DeclaresWhereItBecomesAnEarlierModel)
{
    const std::vector<ModelText> earlier{*parseModelText("example", good, {})};
    const auto model = parseModelText("second", std::string("//! becomes example where b=0;K=a\n") + good, earlier);
    ASSERT_TRUE(model) << model.error().sentence();
    ASSERT_EQ(model->becomes.size(), 1U);
    EXPECT_EQ(model->becomes[0].model, "example");
    EXPECT_EQ(model->becomes[0].where, "b=0;K=a");
}

struct BadText {
    const char* text;
    const char* sentence;
};

class BadTexts : public testing::TestWithParam<BadText> {};

TEST_P(BadTexts, AreRefusedWithFileAndLine)
{
    const auto model = parseModelText("bad", GetParam().text, {});
    ASSERT_FALSE(model);
    EXPECT_NE(model.error().sentence().find(GetParam().sentence), std::string::npos) << model.error().sentence();
}

INSTANTIATE_TEST_SUITE_P(
    ModelText, BadTexts,
    testing::Values(BadText{"", "defines no vec3 shade"}, BadText{"//! nam x\n", "bad.glsl:1: unknown key //! nam"},
                    BadText{"\n//: label x\n", "bad.glsl:2: //: describes a uniform"},
                    BadText{"//! becomes lambert if ks=0\n", "bad.glsl:1: expected: becomes MODEL where"},
                    BadText{"//! becomes lambert where ks\n", "bad.glsl:1: expected: becomes MODEL where"},
                    BadText{"//! becomes lambrt where ks=0\n", "no earlier model: lambrt"},
                    BadText{"uniform float a;\n", "bad.glsl:1: expected: uniform TYPE NAME = DEFAULT;"},
                    BadText{"uniform uint a = 1;\n", "a float, a vec3, a mat3, an int or a float[]"},
                    BadText{"uniform float a = x;\n", "default is not a number: x"},
                    BadText{"uniform vec3 a = vec3(1, 2);\n", "wrong count"},
                    BadText{"uniform mat3 K = mat3(1);\n", "row by row"},
                    BadText{"uniform float a = 1.0;\n//: slider 1\n", "bad.glsl:2: expected: slider"},
                    BadText{"uniform float a = 1.0;\n//: legal 0..x\n", "bad.glsl:2: expected: legal"},
                    BadText{"uniform float a = 1.0;\n//: like other\n", "no earlier model other"},
                    BadText{"uniform float a = 1.0\n", "without ';'"}));

} // namespace
} // namespace reflectance
