// GLSL against 50 digits: every model of the catalogue, the same rows and the same bound form as the core's own
// arithmetic. The bound is 64 (kappa+1) 2^-24 2, twice that of C++'s float: GLSL only promises 2.5 units in the last
// place per division and leaves the order of a dot product's sum open.
#include "core/math/lobe.h"
#include "core/surfaces/library.h"
#include "tests/models/random_cases.h"
#include "tests/render/gl_fixture.h"

#include <cmath>
#include <iostream>

namespace reflectance::test {
namespace {

constexpr std::size_t usualRows = 400;
constexpr double share = 0.5; ///< ratioToBound speaks of 32 (kappa+1) 2^-24; the bound here is twice that

class ParityGl : public GlTest {
protected:
    Vec3d evaluated(const Model& model, const OracleCase& c)
    {
        const Observation row = c.observation();
        const auto got = renderer().evaluate(model, flatValues(model.text, c.parameters), {&row, 1});
        EXPECT_TRUE(got) << got.error().sentence();
        return got ? got.value().front() : Vec3d(NAN);
    }

    /// The worst ratio to the bound over the cases.
    double worstRatio(const Model& model, const std::vector<OracleCase>& cases)
    {
        double worst = 0.0;
        for (const OracleCase& c : cases)
            worst = test::worstRatio(worst, c, evaluated(model, c), false);
        return share * worst;
    }
};

TEST_P(ParityGl, EveryModelStaysWithinTheBound)
{
    for (const Model& model : catalogue()) {
        const double worst = worstRatio(model, randomCases(model.id(), rowsPerModel(1000)));
        EXPECT_LE(worst, 1.0) << model.id();
        std::cout << model.id() << " glsl: worst ratio to the bound " << worst << '\n';
    }
}

TEST_P(ParityGl, EverySurfaceOfTheLibraryStaysWithinTheBound)
{
    for (const LibrarySurface& surface : surfaceLibrary()) {
        const Model& model = **findModel(surface.group->model);
        std::vector<OracleCase> cases = randomCases(model.id(), 16);
        for (OracleCase& c : cases)
            c.parameters = withSurface(surface, {});
        EXPECT_LE(worstRatio(model, cases), 1.0) << surface.id;
    }
}

TEST_P(ParityGl, TheLobeHoldsAtEveryExponent)
{
    const Model& phong = **findModel("phong");
    for (const double n : {0.0, 1.0, 40.0, 1e3, 1e5, 1e6, 1e7}) {
        std::vector<OracleCase> cases = randomCases("phong", usualRows / 2);
        for (OracleCase& c : cases)
            c.parameters["n"] = {n};
        EXPECT_LE(worstRatio(phong, cases), 1.0) << "n = " << n;
    }
}

TEST_P(ParityGl, FollowsTheSamePoliciesAtTheEdges)
{
    const Model& phong = **findModel("phong");
    const Vec3d up{0, 0, 1};
    const auto lobeAt = [&](const Vec3d& V, double n) {
        return evaluated(phong, {"phong", {{"ks", {1.0}}, {"n", {n}}}, up, up, V}).x;
    };
    EXPECT_EQ(lobeAt({1, 0, 0}, 0.0), 0.0) << "H02: 0^0 lies on the rim of the open hemisphere";
    EXPECT_EQ(lobeAt({1, 0, -0.3}, 0.0), 0.0) << "H02";
    EXPECT_EQ(lobeAt({1, 0, -1e-8}, 10.0), 0.0) << "H03: no NaN from a negative base";
    EXPECT_EQ(lobeAt({0.714, 0, 0.7}, 0.0), 1.0) << "H01: n = 0 is 1 inside";
    EXPECT_EQ(lobeAt(up, 1e7), 1.0) << "H04: the peak is exact";
    EXPECT_EQ(lobeAt({0.01, 0, 1}, 1e7), 0.0) << "H05: 7e-218 is 0 in float";
}

TEST_P(ParityGl, NoLobeExceedsItsPeak)
{
    const Model& phong = **findModel("phong");
    for (OracleCase c : randomCases("phong", usualRows)) {
        c.parameters = {{"ks", {1.0}}, {"n", {1e7}}};
        c.I = {1, 1, 1};
        c.V = mirrored(normalized(c.N), normalized(c.L)); // the peak, rounded
        EXPECT_LE(evaluated(phong, c).x, 1.0);
    }
}

/// The planted fault: what every textbook shader writes.
TEST_P(ParityGl, RefusesThePowerOfTheDotProduct)
{
    Model naive = **findModel("phong");
    naive.text.id = "phong_naive";
    const std::size_t call = naive.text.code.find("lobe(mirrored(N, L), V, n)");
    ASSERT_NE(call, std::string::npos);
    naive.text.code.replace(call, 26, "pow(max(dot(mirrored(N, L), V), 0.0), n)");
    std::vector<OracleCase> cases = randomCases("phong", usualRows);
    for (OracleCase& c : cases)
        c.parameters["n"] = {1e6};
    EXPECT_GT(worstRatio(naive, cases), 10.0);
}

IN_EVERY_CONTEXT(ParityGl);

} // namespace
} // namespace reflectance::test
