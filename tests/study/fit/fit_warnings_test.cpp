// A fit says which numbers its data cannot determine, and does not say so where they can.
#include "core/study/fit/fit.h"
#include "tests/study/fit/synthetic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace reflectance;
using testing::HasSubstr;
using testing::Not;

namespace {

SyntheticTable glossy(double n)
{
    return {"hybrid", {{"K", {0.4, 0.0, 0.0, 0.0, 0.4, 0.0, 0.0, 0.0, 0.4}}, {"ks", {0.5}}, {"n", {n}}}, 0.01, 3, 1,
            {}};
}

std::string warningsFor(const SyntheticTable& wanted, const FitOptions& options = {})
{
    const auto fit = fitModel(**findModel(wanted.model), observationsOf(synthetic(wanted)), options);
    return fit ? testing::PrintToString(fit->warnings) : fit.error().sentence();
}

} // namespace

TEST(FitWarnings, AnUnseenLobeIsSaid)
{
    for (const double n : {50.0, 400.0, 3000.0}) {
        SyntheticTable unseen = glossy(n);
        unseen.isSeen = [](const Vec3d& L, const Vec3d& V) { return degreesOffMirror(L, V) > 39.0; };
        const std::string said = warningsFor(unseen);
        EXPECT_THAT(said, HasSubstr("determined")) << n;
        EXPECT_THAT(said, HasSubstr("of the mirror direction")) << n;
    }
}

/// The planted counterpart: the same surfaces, with the lobe in the data.
TEST(FitWarnings, ASeenLobeIsNotComplainedAbout)
{
    for (const double n : {5.0, 25.0, 50.0})
        EXPECT_THAT(warningsFor(glossy(n)), Not(HasSubstr("determined"))) << n;
}

TEST(FitWarnings, ALargeNumberWithASmallErrorIsKnown)
{
    SyntheticTable metal = glossy(25.0);
    metal.values["ks"] = {90.0}; // far beyond its slider
    metal.noise = 3.0;
    EXPECT_THAT(warningsFor(metal), Not(HasSubstr("determined")));
}

TEST(FitWarnings, AModelWithoutALobeDoesNotSpeakOfTheMirrorDirection)
{
    SyntheticTable matte{"oren_nayar", {{"rho", {0.6, 0.6, 0.6}}, {"sigma", {0.4}}}, 0.01, 3, 1, {}};
    matte.isSeen = [](const Vec3d& L, const Vec3d& V) { return degreesOffMirror(L, V) > 39.0; };
    EXPECT_THAT(warningsFor(matte), Not(HasSubstr("mirror")));
}

TEST(FitWarnings, AParameterWithoutEffectIsSaid)
{
    FitOptions options;
    options.fixed["ks"] = {0.0};
    EXPECT_THAT(warningsFor(glossy(25.0), options), HasSubstr("n is not determined: no sample reacts to it"));
}

TEST(FitWarnings, PairsThatCannotBeToldApartAreSaid)
{
    // With n = 0 the lobe is flat wherever it is seen: ks and K pull at the same samples.
    SyntheticTable flat = glossy(0.02);
    flat.isSeen = [](const Vec3d& L, const Vec3d& V) { return L.z > 0.75 && V.z > 0.75; };
    FitOptions options;
    options.fixed["n"] = {0.02};
    EXPECT_THAT(warningsFor(flat, options), HasSubstr("cannot be told apart"));
    EXPECT_THAT(warningsFor(glossy(25.0)), Not(HasSubstr("cannot be told apart")));
}
