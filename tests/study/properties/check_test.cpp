// `check` over the whole catalogue; and faults planted in models, each of which must be called BROKEN by its name.
#include "core/study/properties/check.h"
#include "tests/study/properties/made_models.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace reflectance::test {
namespace {

using properties::checkModel;
using properties::PropertyResult;
using properties::Verdict;

std::set<std::string> brokenIn(const Model& model)
{
    std::set<std::string> broken;
    for (const PropertyResult& result : checkModel(model, {4, 60}))
        if (result.verdict == Verdict::Broken)
            broken.emplace(result.property.name);
    return broken;
}

const PropertyResult& named(const std::vector<PropertyResult>& results, std::string_view name)
{
    return *std::find_if(results.begin(), results.end(), [name](const auto& r) { return r.property.name == name; });
}

TEST(Check, EveryModelIsAsItDeclares)
{
    ASSERT_FALSE(catalogue().empty());
    for (const Model& model : catalogue()) {
        const auto results = checkModel(model);
        EXPECT_GE(results.size(), 9U);
        EXPECT_TRUE(properties::asDeclared(results));
        for (const PropertyResult& r : results)
            EXPECT_NE(r.verdict, Verdict::Broken)
                << model.id() << ": " << r.property.name << ", worst " << r.finding.worst << " at "
                << properties::valuesText(model.text, r.finding.at.values) << ", "
                << properties::directionsText(r.finding.at.directions) << ". " << r.finding.note;
    }
}

TEST(Check, ThePhongOfTheLectureFailsAsExpected)
{
    const auto results = checkModel(**findModel("phong"));
    EXPECT_EQ(named(results, "reciprocity").verdict, Verdict::ExpectedFailure);
    EXPECT_GT(named(results, "reciprocity").finding.worst, 0.5);
    EXPECT_EQ(named(results, "passivity").verdict, Verdict::ExpectedFailure);
    EXPECT_GT(named(results, "passivity").finding.worst, 1.5);
    EXPECT_EQ(named(results, "furnace").verdict, Verdict::Reported);
}

TEST(Check, RepeatsItself)
{
    const Model& hybrid = **findModel("hybrid");
    const auto once = checkModel(hybrid, {4, 60});
    const auto again = checkModel(hybrid, {4, 60});
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
        EXPECT_EQ(once[i].finding.worst, again[i].finding.worst);
        EXPECT_EQ(once[i].finding.at.values, again[i].finding.at.values);
    }
}

TEST(CheckItself, FindsNothingInASoundModel)
{
    EXPECT_EQ(brokenIn(madeModel<Sound>()), std::set<std::string>{});
}

/// A wrong "yes" and a wrong "no" are both broken promises.
TEST(CheckItself, CatchesWrongDeclarations)
{
    Model phong = **findModel("phong");
    phong.text.reciprocal.holds = true;
    EXPECT_EQ(brokenIn(phong), std::set<std::string>{"reciprocity"});
    phong.text.reciprocal.holds = false;
    phong.text.passive.holds = true;
    EXPECT_EQ(brokenIn(phong), std::set<std::string>{"passivity"});
    Model lambert = **findModel("lambert");
    lambert.text.reciprocal.holds = false;
    EXPECT_EQ(brokenIn(lambert), std::set<std::string>{"reciprocity"});
    lambert.text.reciprocal.holds = true;
    lambert.text.passive.holds = false;
    EXPECT_EQ(brokenIn(lambert), std::set<std::string>{"passivity"});
}

TEST(CheckItself, CatchesWrongLimits)
{
    Model hybrid = **findModel("hybrid");
    hybrid.text.becomes = {{"lambert_color", "ks=1e-6"}};
    EXPECT_EQ(brokenIn(hybrid), std::set<std::string>{"limits"});
    hybrid.text.becomes = {{"lambert_color", "k=0"}};
    EXPECT_EQ(brokenIn(hybrid), std::set<std::string>{"limits"}) << "no parameter of this name";
    hybrid.text.becomes = {{"lambrt", "ks=0"}};
    EXPECT_EQ(brokenIn(hybrid), std::set<std::string>{"limits"}) << "no model of this name";
}

TEST(CheckItself, CatchesARangeThatIsTooWide)
{
    Model lambert = **findModel("lambert");
    lambert.text.parameters[0].sliderMax = 1.01;
    EXPECT_EQ(brokenIn(lambert), (std::set<std::string>{"passivity", "furnace"}));
}

struct NoGate {
    static Vec3d shade(const double* values, const Vec3d& N, const Vec3d& L, const Vec3d&, const Vec3d& I)
    {
        return values[0] * std::fabs(dot(N, L)) * I;
    }
};

struct NaNOnTheHorizon {
    static Vec3d shade(const double* values, const Vec3d& N, const Vec3d& L, const Vec3d& V, const Vec3d& I)
    {
        return Sound::shade(values, N, L, V, I) / (dot(N, L) == 0.0 ? 0.0 : 1.0);
    }
};

struct SlightlyNegative {
    static Vec3d shade(const double* values, const Vec3d& N, const Vec3d& L, const Vec3d& V, const Vec3d& I)
    {
        const Vec3d sound = Sound::shade(values, N, L, V, I);
        return dot(N, L) > 0.0 && dot(L, V) < 0.0 ? -1e-6 * sound : sound;
    }
};

struct SquaredLight {
    static Vec3d shade(const double* values, const Vec3d& N, const Vec3d& L, const Vec3d& V, const Vec3d& I)
    {
        return Sound::shade(values, N, L, V, I * I);
    }
};

struct WorldUp {
    static Vec3d shade(const double* values, const Vec3d& N, const Vec3d& L, const Vec3d& V, const Vec3d& I)
    {
        // Half the size at most, so that nothing else breaks.
        return Sound::shade(values, N, L, V, I) * (0.5 + 1e-5 * N.z);
    }
};

/// The cosine of the viewer in place of nothing: twice it keeps the albedo at kd only on paper.
struct ViewerCosine {
    static Vec3d shade(const double* values, const Vec3d& N, const Vec3d& L, const Vec3d& V, const Vec3d& I)
    {
        return Sound::shade(values, N, L, V, I) * (dot(N, V) > 0.0 ? dot(N, V) : 0.0);
    }
};

/// 1e-5 too bright: far below what an eye or a random estimate would notice.
struct SlightlyTooBright {
    static Vec3d shade(const double* values, const Vec3d& N, const Vec3d& L, const Vec3d& V, const Vec3d& I)
    {
        return Sound::shade(values, N, L, V, I) * (1.0 + 1e-5);
    }
};

TEST(CheckItself, CatchesFaultsInKernels)
{
    using Names = std::set<std::string>;
    EXPECT_EQ(brokenIn(madeModel<NoGate>()), (Names{"horizon"}));
    EXPECT_EQ(brokenIn(madeModel<NaNOnTheHorizon>()), (Names{"horizon"}));
    EXPECT_EQ(brokenIn(madeModel<SlightlyNegative>()), (Names{"sign"}));
    EXPECT_EQ(brokenIn(madeModel<SquaredLight>()), (Names{"scaling"}));
    EXPECT_EQ(brokenIn(madeModel<WorldUp>()), (Names{"rotation"}));
    EXPECT_EQ(brokenIn(madeModel<ViewerCosine>()), (Names{"reciprocity"}));
    EXPECT_EQ(brokenIn(madeModel<SlightlyTooBright>()), (Names{"passivity", "furnace"}));
}

/// A fault in one precision alone is found as well.
TEST(CheckItself, LooksAtEveryPrecision)
{
    Model model = madeModel<Sound>();
    model.lanes.shade = shadeAll<SquaredLight, float>;
    EXPECT_EQ(brokenIn(model), (std::set<std::string>{"scaling"}));
    const auto results = checkModel(model, {4, 60});
    EXPECT_EQ(named(results, "scaling").finding.at.precision, Precision::Simd);
}

} // namespace
} // namespace reflectance::test
