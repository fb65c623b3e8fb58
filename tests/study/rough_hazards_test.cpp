// The rows H30 to H36 wait for rough matte models. Here such models stand in, to see that the rows wake up by
// themselves, hold for a sound implementation and find an unsound one.
#include "core/study/extremes/extremes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

namespace reflectance::test {
namespace {

using std::numbers::pi;

constexpr const char* modelText = "uniform vec3 rho = vec3(0.8);\n//: legal 0 .. 1\nuniform float ROUGHNESS = 0.3;\n"
                                  "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return rho; }\n";

Model standIn(const std::string& id, const std::string& roughness)
{
    std::string text = modelText;
    text.replace(text.find("ROUGHNESS"), 9, roughness);
    auto parsed = parseModelText(id, text, {});
    EXPECT_TRUE(parsed);
    Model model;
    model.text = *std::move(parsed);
    return model;
}

const std::vector<Model>& standIns()
{
    static const std::vector<Model> models{standIn("oren_nayar", "sigma"), standIn("oren_nayar_full", "sigma"),
                                           standIn("oren_nayar_fujii", "r"), standIn("eon", "r")};
    return models;
}

/// What the formulas need of the directions.
struct Geometry {
    double li, lv; ///< N.L, N.V
    double s;      ///< L.V - (N.L)(N.V)
};

struct Angles {
    double thetaL, thetaV, cosAzimuth;
};

/// Without acos: atan2 of sine and cosine.
Angles soundAngles(const Geometry& g, const Vec3d& N, const Vec3d& L, const Vec3d& V)
{
    const double sinL = length(cross(N, L));
    const double sinV = length(cross(N, V));
    const bool defined = sinL > 0.0 && sinV > 0.0;
    return {std::atan2(sinL, g.li), std::atan2(sinV, g.lv),
            defined ? dot(cross(N, L), cross(N, V)) / (sinL * sinV) : 0.0};
}

Angles acosAngles(const Geometry& g, const Vec3d& N, const Vec3d& L, const Vec3d& V)
{
    const double sinL = length(cross(N, L));
    const double sinV = length(cross(N, V));
    return {std::acos(g.li), std::acos(g.lv), dot(cross(N, L), cross(N, V)) / (sinL * sinV)};
}

double qualitative(double sigma, const Geometry& g)
{
    const double s2 = sigma * sigma;
    return 1.0 - 0.5 * s2 / (s2 + 0.33) + 0.45 * s2 / (s2 + 0.09) * std::max(0.0, g.s) / std::max(g.li, g.lv);
}

double qualitativeInAngles(double sigma, const Angles& a)
{
    const double s2 = sigma * sigma;
    return 1.0 - 0.5 * s2 / (s2 + 0.33) +
           0.45 * s2 / (s2 + 0.09) * std::max(0.0, a.cosAzimuth) * std::sin(std::max(a.thetaL, a.thetaV)) *
               std::tan(std::min(a.thetaL, a.thetaV));
}

/// Oren and Nayar 1994, both terms.
double full(double rho, double sigma, const Angles& a)
{
    const double s2 = sigma * sigma;
    const double alpha = std::max(a.thetaL, a.thetaV);
    const double beta = std::min(a.thetaL, a.thetaV);
    const double c = a.cosAzimuth;
    const double behind = c < 0.0 ? std::pow(2.0 * beta / pi, 3) : 0.0;
    const double C1 = 1.0 - 0.5 * s2 / (s2 + 0.33);
    const double C2 = 0.45 * s2 / (s2 + 0.09) * (std::sin(alpha) - behind);
    const double C3 = 0.125 * s2 / (s2 + 0.09) * std::pow(4.0 * alpha * beta / (pi * pi), 2);
    const double L1 = C1 + c * C2 * std::tan(beta) + (1.0 - std::fabs(c)) * C3 * std::tan((alpha + beta) / 2.0);
    return L1 + 0.17 * rho * s2 / (s2 + 0.13) * (1.0 - c * std::pow(2.0 * beta / pi, 2));
}

double fujii(double r, const Geometry& g)
{
    const double factor = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * pi)) * r);
    return factor * (1.0 + r * (g.s > 0.0 ? g.s / std::max(g.li, g.lv) : g.s));
}

/// G of EON's directional albedo (Portsmouth, Kutz and Hill 2025): E = A_F (1 + r G / pi).
double eonG(double mu)
{
    const double S = std::sqrt(1.0 - mu * mu);
    return S * (std::acos(mu) - S * mu) + 2.0 / 3.0 * (S * mu * (1.0 + S + S * S) / (1.0 + S) - S);
}

/// The lobe of multiple scattering is a product of 1 - E over 1 - <E>. As it stands in the paper that is 0/0 at r = 0
/// and is kept apart from it by a guard; with r A_F taken out of each, nothing cancels.
double eon(double rho, double r, const Geometry& g, bool asInThePaper)
{
    const double c1 = 0.5 - 2.0 / (3.0 * pi);
    const double c2 = 2.0 / 3.0 - 28.0 / (15.0 * pi);
    const double factor = 1.0 / (1.0 + c1 * r);
    const double mean = factor * (1.0 + c2 * r);
    const auto missing = [&](double mu) { return c1 - eonG(mu) / pi; };
    double many = rho * rho * mean / (1.0 - rho * (1.0 - mean));
    if (asInThePaper) {
        const auto guarded = [](double x) { return std::max(x, 1e-7); };
        many *= guarded(1.0 - factor * (1.0 + r * eonG(g.li) / pi)) *
                guarded(1.0 - factor * (1.0 + r * eonG(g.lv) / pi)) / guarded(1.0 - mean);
    } else {
        many *= r * factor * missing(g.li) * missing(g.lv) / (c1 - c2);
    }
    return rho * fujii(r, g) + many;
}

struct StandInModels {
    Angles (*angles)(const Geometry&, const Vec3d&, const Vec3d&, const Vec3d&) = soundAngles;
    bool inAngles = false; ///< the qualitative form too
    bool guardedEon = false;

    double factor(const std::string& id, double rho, double roughness, const Vec3d& N, const Vec3d& L,
                  const Vec3d& V) const
    {
        const Geometry g{dot(N, L), dot(N, V), dot(L, V) - dot(N, L) * dot(N, V)};
        if (!(g.li > 0.0) || !(g.lv > 0.0))
            return 0.0;
        if (id == "oren_nayar")
            return rho * g.li *
                   (inAngles ? qualitativeInAngles(roughness, angles(g, N, L, V)) : qualitative(roughness, g));
        if (id == "oren_nayar_full")
            return rho * g.li * full(rho, roughness, angles(g, N, L, V));
        return g.li * (id == "eon" ? eon(rho, roughness, g, guardedEon) : rho * fujii(roughness, g));
    }
};

/// The stand-ins alone, in double whatever the arithmetic asked for.
std::vector<Finding> findingsOn(const StandInModels& models)
{
    Instruments instruments = programInstruments(nullptr, "not needed here");
    instruments.models = &standIns();
    instruments.evaluate = [models](const Model& model, std::span<const double> v, std::span<const Observation> rows,
                                    Precision) -> Result<std::vector<Vec3d>> {
        std::vector<Vec3d> results;
        for (const Observation& row : rows) {
            const Vec3d N = normalized(row.N);
            const Vec3d L = normalized(row.lights[0].L);
            const Vec3d V = normalized(row.V);
            const auto one = [&](double rho) { return models.factor(model.id(), rho, v[3], N, L, V); };
            results.emplace_back(one(v[0]), one(v[1]), one(v[2]));
        }
        return results;
    };
    std::vector<Finding> findings;
    for (const char* id : {"H24", "H30", "H31", "H32", "H33", "H34", "H35", "H36"})
        for (Finding& finding : runExtremes(instruments, id))
            findings.push_back(std::move(finding));
    return findings;
}

std::set<std::string> failedIds(const StandInModels& models)
{
    std::set<std::string> ids;
    for (const Finding& finding : findingsOn(models))
        if (finding.verdict == Verdict::Fail)
            ids.insert(finding.id);
    return ids;
}

TEST(RoughHazards, HoldForASoundImplementation)
{
    std::size_t passed = 0;
    for (const Finding& f : findingsOn({})) {
        EXPECT_NE(f.verdict, Verdict::Fail)
            << f.id << ' ' << f.input << "\n  expected " << f.expected << "\n  found " << f.found;
        passed += f.verdict == Verdict::Pass ? 1 : 0;
    }
    // 12 rows in three arithmetics, and EON's refusal of rho > 1.
    EXPECT_EQ(passed, 37U);
}

TEST(RoughHazards, FindAcosAndTangents)
{
    EXPECT_TRUE(failedIds({acosAngles, false, false}).contains("H35"));
    EXPECT_TRUE(failedIds({acosAngles, true, false}).contains("H31"));
    EXPECT_TRUE(failedIds({acosAngles, true, false}).contains("H32"));
}

TEST(RoughHazards, FindAGuardThatShows)
{
    EXPECT_EQ(failedIds({soundAngles, false, true}), (std::set<std::string>{"H30", "H36"}));
}

TEST(RoughHazards, AreNotCountedWithoutTheirModels)
{
    Instruments instruments = programInstruments(nullptr, "not needed here");
    static const std::vector<Model> none;
    instruments.models = &none;
    const auto findings = runExtremes(instruments, "H34");
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].verdict, Verdict::NotYet);
    EXPECT_EQ(findings[0].found, "not applicable yet: there is no model 'oren_nayar_full'");
}

} // namespace
} // namespace reflectance::test
