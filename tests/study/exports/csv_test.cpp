// The vectors that exports carry: they are what the core computes, their tolerance holds for its own arithmetics, and a
// table's rows say all of it.
#include "core/base/text.h"
#include "core/reflectance/evaluate.h"
#include "core/study/exports/test_vectors.h"
#include "tests/study/exports/subjects.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

std::vector<Observation> rowsOf(const std::vector<TestVector>& vectors)
{
    std::vector<Observation> rows;
    for (const TestVector& v : vectors)
        rows.push_back({v.N, v.V, {{v.L, v.I, v.lightRadius}}});
    return rows;
}

std::size_t beyond(const std::vector<TestVector>& vectors, const std::vector<Vec3d>& got, double roundoff)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        const Vec3d off = got[i] - vectors[i].expected;
        const Vec3d most = toleranceOf(vectors[i], roundoff);
        count += std::fabs(off.x) <= most.x && std::fabs(off.y) <= most.y && std::fabs(off.z) <= most.z ? 0 : 1;
    }
    return count;
}

TEST(TestVectors, HoldForEveryModelInEveryArithmetic)
{
    for (const Model& model : catalogue()) {
        if (model.text.usesTable)
            continue;
        const ExportSubject subject = subjectFor(model.id());
        for (const auto& vectors : {testVectors(model, subject.values), gridVectors(model, subject.values)}) {
            const auto rows = rowsOf(vectors);
            // Doubles are normalised once more there: that moves a component by a unit, which the tolerance allows.
            EXPECT_EQ(beyond(vectors, evaluate(model, subject.values, rows, Precision::Double), 0x1p-53), 0U)
                << model.id();
            EXPECT_EQ(beyond(vectors, evaluate(model, subject.values, rows, Precision::Float), 0x1p-24), 0U)
                << model.id();
            EXPECT_EQ(beyond(vectors, evaluate(model, subject.values, rows, Precision::Simd), 0x1p-24), 0U)
                << model.id();
        }
    }
}

TEST(TestVectors, MeetTheHighlightAtEveryExponent)
{
    ExportSubject phong = subjectFor("phong");
    for (const double n : {1.0, 100.0, 1e5, 1e7}) {
        phong.values[phong.model->text.find("n")->offset] = n;
        std::size_t between = 0;
        for (const TestVector& v : testVectors(*phong.model, phong.values))
            between += v.expected.x > 1e-6 && v.expected.x < 0.5 * v.I.x ? 1 : 0;
        EXPECT_GE(between, 3U) << "n = " << n << ": on the flank, where the exponent shows";
    }
}

/// Lambert: kd (N.L) moves by kd per unit of N and L along each other.
TEST(TestVectors, KnowHowMuchInputsMatter)
{
    const ExportSubject lambert = subjectFor("lambert");
    const double kd = lambert.values[0];
    const TestVector first = testVectors(*lambert.model, lambert.values).front();
    EXPECT_NEAR(first.expected.x, kd, 1e-15);
    EXPECT_NEAR(first.sensitivity.x, 3.0 * kd, 1e-5) << "N, L and kd itself, each by kd; differences of 1e-6";
    EXPECT_NEAR(toleranceOf(first, 0x1p-24).x, 64.0 * 4.0 * kd * 0x1p-23, 1e-9);
}

TEST(ExportedCsv, HasOneFieldPerColumnAndNamesItsParameters)
{
    const std::string text = exported(subjectFor("hybrid"), ExportForm::Csv).value();
    const auto lines = split(trimmed(text), '\n');
    EXPECT_EQ(lines[0], "id,model,params,N,L,V,light_rgb,light_radius,expected,tolerance_double,tolerance_float");
    EXPECT_GT(lines.size(), 500U);
    for (const std::string_view line : lines)
        ASSERT_EQ(split(line, ',').size(), 11U) << line;
    EXPECT_EQ(split(lines[1], ',')[2], "K=0.62 0.05 0.02 0.06 0.34 0.03 0.02 0.05 0.22;ks=0.25 0.25 0.25;n=40");
    EXPECT_EQ(words(split(lines[1], ',')[8]).size(), 3U);
}

TEST(ExportedCode, RefusesWhatIsNoFormula)
{
    const ExportSubject table = subjectFor("table");
    for (const ExportForm form : {ExportForm::Glsl, ExportForm::Cpp}) {
        const auto text = exported(table, form);
        ASSERT_FALSE(text);
        EXPECT_NE(text.error().message.find("table convert"), std::string::npos);
    }
    EXPECT_TRUE(exported(table, ExportForm::Csv));
    ExportSubject endless = subjectFor("lambert");
    endless.values[0] = INFINITY;
    EXPECT_FALSE(exported(endless, ExportForm::Cpp));
}

TEST(ExportedCode, HasNamesThatGlslTakes)
{
    for (const auto& [file, prefix] :
         {std::pair{"2_wide.glsl", "model_2_wide_"}, {"a__b_.glsl", "a_b_"}, {"gl_x.glsl", "model_gl_x_"}}) {
        const auto own = ownModel(file, "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return I; }");
        ASSERT_TRUE(own);
        const auto text = exported({own->get(), {}}, ExportForm::Glsl);
        EXPECT_NE(text.value().find(std::string("vec3 ") + prefix + "shade("), std::string::npos) << file;
    }
}

TEST(ExportForms, AreKnownByTheirFiles)
{
    EXPECT_EQ(formForFile("a/Phong.GLSL"), ExportForm::Glsl);
    EXPECT_EQ(formForFile("phong.hpp"), ExportForm::Cpp);
    EXPECT_EQ(formForFile("phong.csv"), ExportForm::Csv);
    EXPECT_EQ(formForFile("phong.txt"), std::nullopt);
}

} // namespace
} // namespace reflectance::test
