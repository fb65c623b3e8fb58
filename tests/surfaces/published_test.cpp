// Published constants, held against their own formulas, which are written out here from the papers, in angles, with pow and
// acos and no line of the program's.
#include "core/base/text.h"
#include "core/reflectance/evaluate.h"
#include "core/surfaces/library.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;
const double channelScale[3] = {1.0, 1.15, 1.66}; // of the MERL files, which the published colours lack

const LibrarySurface& surface(const std::string& id)
{
    const auto found = findSurface(id);
    EXPECT_TRUE(found) << id;
    return **found;
}

/// Pairs of directions in the plane x, z and out of it: about the mirrored light, where the lobes are, and away from it.
struct Pair {
    Vec3d L, V;
};
std::vector<Pair> pairs()
{
    std::vector<Pair> made;
    for (const double light : {0.0, 0.5, 1.0, 1.3})
        for (const double viewer : {light, light + 0.01, light + 0.05, 0.2})
            for (const double azimuth : {0.0, 0.02, 2.0})
                made.push_back(
                    {{-std::sin(light), 0, std::cos(light)},
                     {std::sin(viewer) * std::cos(azimuth), std::sin(viewer) * std::sin(azimuth), std::cos(viewer)}});
    return made;
}

Vec3d evaluated(const LibrarySurface& from, const Pair& pair)
{
    const Model& model = **findModel(from.group->model);
    const Observation row{{0, 0, 1}, pair.V, {{pair.L, Vec3d(1.0), 0.0}}};
    return evaluate(model, flatValues(model.text, from.values), std::span(&row, 1), Precision::Double)[0];
}

/// Angles of the half vector to N and to L.
struct HalfAngles {
    double h, d;
};
HalfAngles halfAngles(const Pair& pair)
{
    const Vec3d H = normalized(pair.L + pair.V);
    return {std::atan2(std::hypot(H.x, H.y), H.z), std::acos(std::min(1.0, dot(H, pair.L)))};
}

/// `brdf(channel, pair)` is the published formula. What is compared is pi f (N.L). Textbook forms lose about n, or
/// 1 / m^2, times the rounding of an angle: 1e5 times 1e-16 leaves 1e-10 of the peak.
template <class Brdf> void expectPublished(const LibrarySurface& from, const Brdf& brdf)
{
    double peak = 0.0;
    for (const Pair& pair : pairs())
        peak = std::max(peak, evaluated(from, pair).x);
    for (const Pair& pair : pairs()) {
        const Vec3d ours = evaluated(from, pair);
        const double value[3] = {ours.x, ours.y, ours.z};
        for (int c = 0; c < 3; ++c) {
            const double published = pi * brdf(c, pair) * pair.L.z;
            EXPECT_NEAR(value[c], published, 1e-9 * std::max(published, peak)) << from.id << " channel " << c;
        }
    }
}

TEST(OpenGl, HoldsThe24MaterialsWithTheirExponentsAndAmbientColours)
{
    const auto all = searchSurfaces("", "opengl");
    ASSERT_EQ(all.size(), 24U);
    for (const LibrarySurface* material : all) {
        ASSERT_EQ(material->facts.size(), 1U) << material->id;
        EXPECT_EQ(material->facts[0].name, "ambient");
    }
    const auto& gold = surface("gold").values;
    EXPECT_EQ(gold.at("ks"), (std::vector<double>{0.628281, 0.555802, 0.366065})); // a web copy has another green
    EXPECT_EQ(gold.at("n")[0], 51.2);
    EXPECT_NEAR(surface("opengl/brass").values.at("n")[0], 0.21794872 * 128, 1e-9);
    EXPECT_EQ(surface("pearl").values.at("n")[0], 11.264);
    EXPECT_EQ(surface("opengl/red-rubber").values.at("n")[0], 10.0);
}

TEST(OpenGl, DrawsWhatOpenGlsOwnLightingDraws)
{
    // diffuse (N.L) + specular (N.H)^shininess where N.L > 0; brass.
    const double diffuse[3] = {0.780392, 0.568627, 0.113725}, specular[3] = {0.992157, 0.941176, 0.807843};
    expectPublished(surface("opengl/brass"), [&](int c, const Pair& pair) {
        const double gloss = std::pow(std::cos(halfAngles(pair).h), 27.89743616);
        return (diffuse[c] * pair.L.z + specular[c] * gloss) / (pi * pair.L.z);
    });
}

TEST(OpenGl, OnlyFiveMaterialsKeepDiffusePlusSpecularWithinOne)
{
    std::vector<std::string> within;
    for (const LibrarySurface* material : searchSurfaces("", "opengl")) {
        const auto& K = material->values.at("K");
        const auto& ks = material->values.at("ks");
        if (std::max({K[0] + ks[0], K[4] + ks[1], K[8] + ks[2]}) <= 1.0)
            within.push_back(material->name);
    }
    EXPECT_THAT(within, testing::ElementsAre("obsidian", "copper", "black plastic", "green plastic", "black rubber"));
}

// kd, s and the shape as printed in the supplement of Ngan et al. 2005.
struct Printed {
    const char* name;
    double kd[3], s[3], shape, f0;
};

TEST(Ngan, BlinnPhongIsThePublishedBrdf)
{
    const Printed printed[] = {{"alum-bronze", {.0864, .0597, .0302}, {.015, .00818, .00381}, 1290, 0},
                               {"nickel", {.0301, .0257, .0173}, {.0665, .0486, .0285}, 1040, 0},
                               {"white-paint", {.312, .265, .178}, {.0068, .00514, .00358}, 499, 0}};
    for (const Printed& p : printed)
        expectPublished(surface(std::string("ngan_blinn_phong/") + p.name), [&](int c, const Pair& pair) {
            const double lobe = (p.shape + 2) / (2 * pi) * std::pow(std::cos(halfAngles(pair).h), p.shape);
            return channelScale[c] * (p.kd[c] / pi + p.s[c] * lobe);
        });
}

TEST(Ngan, WardIsThePublishedBrdf)
{
    const Printed printed[] = {{"alum-bronze", {.0851, .0586, .0294}, {.0484, .0274, .0135}, .0357, 0},
                               {"nickel", {.0221, .0178, .0107}, {.204, .154, .0946}, .0432, 0},
                               {"white-paint", {.311, .264, .177}, {.0219, .0164, .0116}, .0383, 0}};
    for (const Printed& p : printed)
        expectPublished(surface(std::string("ngan_ward/") + p.name), [&](int c, const Pair& pair) {
            const double slope = std::tan(halfAngles(pair).h) / p.shape;
            const double lobe =
                std::exp(-slope * slope) / (4 * pi * p.shape * p.shape * std::sqrt(pair.L.z * pair.V.z));
            return channelScale[c] * (p.kd[c] / pi + p.s[c] * lobe);
        });
}

TEST(Ngan, CookTorranceIsThePublishedBrdfWithItsPi)
{
    const Printed printed[] = {{"alum-bronze", {.0886, .0602, .0299}, {.118, .0698, .0371}, .0367, .203},
                               {"nickel", {.0342, .0256, .014}, {.16, .124, .0798}, .0424, .733},
                               {"white-paint", {.317, .269, .181}, {.183, .137, .101}, .0386, .0145}};
    for (const Printed& p : printed)
        expectPublished(surface(std::string("ngan_cook_torrance/") + p.name), [&](int c, const Pair& pair) {
            const auto [h, d] = halfAngles(pair);
            const double slope = std::tan(h) / p.shape;
            const double D = std::exp(-slope * slope) / (pi * p.shape * p.shape * std::pow(std::cos(h), 4));
            const double G =
                std::min({1.0, 2 * std::cos(h) * pair.V.z / std::cos(d), 2 * std::cos(h) * pair.L.z / std::cos(d)});
            const double F = p.f0 + (1 - p.f0) * std::pow(1 - std::cos(d), 5);
            return channelScale[c] * (p.kd[c] / pi + p.s[c] * F * D * G / (pi * pair.L.z * pair.V.z));
        });
}

double medianOf(std::vector<double> numbers)
{
    std::nth_element(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2), numbers.end());
    return numbers[numbers.size() / 2];
}

TEST(Ngan, ThreeModelsSeeTheSameHighlights)
{
    // A lobe (N.H)^n with (n + 2) / (2 pi) holds about four times its coefficient, Ward's about its own, Cook-Torrance's
    // ks f0: three fits of one material. If Blinn-Phong's exponent were meant about R the first ratio would be 0.23, if
    // Cook-Torrance's D lacked its pi the second would be 2.4.
    std::vector<double> blinnToWard, cookToWard;
    for (const LibrarySurface* ward : searchSurfaces("", "ngan_ward")) {
        const auto& blinn = surface("ngan_blinn_phong/" + ward->name).values;
        const auto& cook = surface("ngan_cook_torrance/" + ward->name).values;
        const double green = ward->values.at("ks")[1];
        if (green <= 0.0)
            continue;
        blinnToWard.push_back(4.0 * blinn.at("ks")[1] / green);
        if (cook.at("f0")[1] > 0.6 && cook.at("m")[0] < 0.4) // metals: F hardly depends on the angle
            cookToWard.push_back(cook.at("ks")[1] * cook.at("f0")[1] / green);
    }
    EXPECT_EQ(blinnToWard.size() >= 80U, true);
    EXPECT_NEAR(medianOf(blinnToWard), 0.92, 0.1);
    EXPECT_NEAR(medianOf(cookToWard), 0.76, 0.1);
}

} // namespace
} // namespace reflectance
