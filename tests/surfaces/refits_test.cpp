// The refits of CUReT: complete, called refits everywhere, and marked where Oren-Nayar does not describe the surface.
#include "core/base/text.h"
#include "core/surfaces/library.h"

#include <gmock/gmock.h>

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

} // namespace
} // namespace reflectance
