// The refits of CUReT: complete, called refits everywhere, and marked where Oren-Nayar does not describe the surface.
#include "core/base/text.h"
#include "core/reflectance/evaluate.h"
#include "core/surfaces/library.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace reflectance {
namespace {

using testing::HasSubstr;

std::string factOf(const LibrarySurface& surface, const std::string& name)
{
    for (const SurfaceFact& fact : surface.facts)
        if (fact.name == name)
            return fact.text;
    return {};
}

TEST(Refits, AreNeverTakenForTheAuthorsOwnNumbers)
{
    for (const auto& group : surfaceGroups())
        if (group->id.starts_with("curet")) {
            EXPECT_THAT(group->name, HasSubstr("refit"));
            EXPECT_THAT(group->source, HasSubstr("refit"));
            EXPECT_THAT(group->note, HasSubstr("A refit, not the authors' own"));
        }
}

TEST(Refits, OfOrenNayarHoldEverySampleOnceAndInOrder)
{
    const auto surfaces = searchSurfaces("", "curet_oren_nayar");
    ASSERT_EQ(surfaces.size(), 61U);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        EXPECT_EQ(factOf(*surfaces[i], "sample"), std::to_string(i + 1));
        const double rho = surfaces[i]->values.at("rho")[0];
        EXPECT_TRUE(rho > 0.0 && rho < 1.0) << surfaces[i]->id;
    }
}

TEST(Refits, SayWhereLambertFitsBestAndWhereTheFitRanIntoItsLimit)
{
    int lambert = 0, limit = 0;
    for (const LibrarySurface* surface : searchSurfaces("", "curet_oren_nayar")) {
        const double sigma = surface->values.at("sigma")[0];
        const std::string remark = factOf(*surface, "remark");
        EXPECT_EQ(remark == "Lambert fits best", sigma == 0.0) << surface->id;
        EXPECT_EQ(remark == "sigma at its limit", sigma == 1.4) << surface->id;
        lambert += sigma == 0.0;
        limit += sigma == 1.4;
        // Lambert is Oren-Nayar with sigma = 0, so the fit cannot be worse; 2e-6: both are printed to six digits.
        EXPECT_LE(*parseNumber(factOf(*surface, "rms")), *parseNumber(factOf(*surface, "rms of Lambert")) + 2e-6)
            << surface->id;
    }
    EXPECT_EQ(lambert, 25);
    EXPECT_EQ(limit, 5);
}

/// Zernike's radial polynomial by its sum of factorials.
double radial(int n, int l, double r)
{
    double sum = 0.0;
    for (int k = 0; k <= (n - l) / 2; ++k)
        sum += (k % 2 ? -1.0 : 1.0) * std::tgamma(n - k + 1) /
               (std::tgamma(k + 1) * std::tgamma((n + l) / 2 - k + 1) * std::tgamma((n - l) / 2 - k + 1)) *
               std::pow(r, n - 2 * k);
    return sum;
}

/// The BRDF that the coefficients were fitted with: l <= m <= n <= order, by l, then n, then m; each mode normalised over
/// both hemispheres and made reciprocal (Koenderink, van Doorn and Stavridi, ECCV 1996).
double scattered(const std::vector<double>& a, int order, double thetaI, double thetaV, double azimuth)
{
    const double ri = std::sqrt(2.0) * std::sin(thetaI / 2), rv = std::sqrt(2.0) * std::sin(thetaV / 2);
    double sum = 0.0;
    std::size_t next = 0;
    for (int l = 0; l <= order; ++l)
        for (int n = l; n <= order; n += 2)
            for (int m = l; m <= n; m += 2) {
                const double one = radial(n, l, ri) * radial(m, l, rv), other = radial(m, l, ri) * radial(n, l, rv);
                const double S = n == m ? one : (one + other) / std::sqrt(2.0);
                const double C = l == 0 ? 1.0 : std::sqrt(2.0) * std::cos(l * azimuth);
                sum += a[next++] * std::sqrt((n + 1.0) * (m + 1.0)) / (2 * std::numbers::pi) * S * C;
            }
    EXPECT_EQ(next, a.size());
    return sum;
}

TEST(Refits, OfKoenderinkMeanWhatTheyWereFittedWith)
{
    for (const int order : {2, 8}) {
        const auto surfaces = searchSurfaces("", "curet_koenderink" + std::to_string(order));
        ASSERT_EQ(surfaces.size(), 61U);
        for (const LibrarySurface* surface : surfaces) {
            const Model& model = **findModel("koenderink");
            EXPECT_EQ(surface->values.at("order")[0], order);
            const double thetaI = 0.5, thetaV = 0.9, azimuth = 2.0;
            const Observation row{
                {0, 0, 1},
                {std::sin(thetaV) * std::cos(azimuth), std::sin(thetaV) * std::sin(azimuth), std::cos(thetaV)},
                {{{std::sin(thetaI), 0, std::cos(thetaI)}, Vec3d(1.0), 0.0}}};
            const double factor =
                evaluate(model, flatValues(model.text, surface->values), std::span(&row, 1), Precision::Double)[0].y;
            const double brdf = scattered(surface->values.at("coefficients"), order, thetaI, thetaV, azimuth);
            // Sums of up to 55 terms of order 1, in another order: 1e-13 is about a hundred roundings.
            EXPECT_NEAR(factor, std::numbers::pi * brdf * std::cos(thetaI), 1e-13) << surface->id;
        }
    }
}

} // namespace
} // namespace reflectance
