// H30 to H36: rough matte surfaces. The rows wait for their models; expected values come from the angle forms.
#include "core/base/text.h"
#include "core/study/extremes/hazard.h"
#include "core/study/extremes/rough_forms.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

constexpr double rho = 0.9;

Vec3d at(double theta, double azimuth)
{
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)};
}

/// A model of this id with its one roughness, sigma or r.
Question rough(const std::string& model, double roughness)
{
    const bool hasSigma = model == "oren_nayar" || model == "oren_nayar_full";
    return {model, {{"rho", {rho, rho, rho}}, {hasSigma ? "sigma" : "r", {roughness}}}};
}

/// Seen along N, with the light at an angle to it.
Question lit(Question question, double theta)
{
    question.L = at(theta, 0.4);
    return question;
}

Question grazingBoth(double g)
{
    Question question = rough("oren_nayar", 0.6);
    question.L = {1, 0, g};
    question.V = {1, 0, 1.5 * g};
    return question;
}

Question forwardGrazing()
{
    Question question = rough("oren_nayar_full", 1.0);
    question.parameters["rho"] = {0.9, 0.5, 0.1};
    question.L = at(1.55, 0.0);
    question.V = at(1.55, 3.0);
    return question;
}

std::function<Outcome(Bench&)> smoothIsLambert(const std::string& model)
{
    return [model](Bench& bench) {
        double worst = 0.0;
        for (const double theta : {0.0, 0.3, 0.9, 1.4, 1.57}) {
            Question question = rough(model, 0.0);
            question.L = at(theta, 0.0);
            question.V = at(0.7, 2.0);
            const double lambert = rho * std::cos(theta);
            worst = worse(worst, largestOf(bench.ask(question) - Vec3d(lambert)) / lambert);
        }
        // cos(1.57) = 8e-4 comes from a rounded direction, but N = (0,0,1) reads it off exactly.
        return within(worst, 4.0 * bench.unit(), "off Lambert by");
    };
}

std::function<Outcome(Bench&)> withoutAzimuth(const std::string& model, double (*expected)(double theta))
{
    return [model, expected](Bench& bench) {
        double worst = 0.0;
        for (const bool viewerAtN : {true, false}) {
            Question question = rough(model, 0.5);
            (viewerAtN ? question.L : question.V) = at(0.8, 0.4);
            const double truth = expected(viewerAtN ? 0.8 : 0.0);
            worst = worse(worst, largestOf(bench.ask(question) - Vec3d(truth)) / truth);
        }
        return within(worst, bench.bound(1.0), "relative error");
    };
}

double qualitativeFromN(double theta)
{
    return rho * std::cos(theta) * (1.0 - 0.5 * 0.25 / 0.58);
}

double fullFromN(double theta)
{
    return qualitativeFromN(theta) + 0.17 * rho * rho * std::cos(theta) * 0.25 / 0.38;
}

double fujiiFromN(double theta)
{
    return rho * std::cos(theta) * fujiiFactor(0.5);
}

Outcome bothGrazing(Bench& bench)
{
    double worst = 0.0;
    Vec3d last;
    for (int k = 1; k <= 15; ++k) {
        const double g = std::pow(10.0, -k);
        // A g / sqrt(1 + g^2) + B / (1.5 (1 + g^2)) with sigma^2 = 0.36: tan(beta) is 1 / (1.5 g).
        const double truth = rho * ((1.0 - 0.18 / 0.69) * g / std::sqrt(1.0 + g * g) + 0.36 / (1.5 * (1.0 + g * g)));
        last = bench.ask(grazingBoth(g));
        worst = worse(worst, largestOf(last - Vec3d(truth)) / truth);
    }
    const Outcome outcome = within(worst, bench.bound(4.0), "relative error");
    return {outcome.holds, textOf(last) + ", " + outcome.found};
}

Outcome beyondTheModel(Bench& bench)
{
    double worst = 0.0;
    Vec3d last;
    for (const double sigma : {2.0, 10.0, 1e3}) {
        last = bench.ask(rough("oren_nayar", sigma));
        const double truth = rho * (1.0 - 0.5 * sigma * sigma / (sigma * sigma + 0.33));
        worst = worse(worst, largestOf(last - Vec3d(truth)) / truth);
    }
    const Outcome outcome = within(worst, bench.bound(1.0), "relative error");
    return {outcome.holds, textOf(last) + ", " + outcome.found};
}

Outcome negativeRadiance(Bench& bench)
{
    const Vec3d got = bench.ask(forwardGrazing());
    const auto truth = [](double albedo) { return fullOrenNayar(albedo, 1.0, 1.55, 1.55, std::cos(3.0)); };
    // tan(1.55) magnifies rounding 1 / (sin cos) = 48 times; the terms are each about 0.1 and cancel.
    const double error = largestOf(got - Vec3d(truth(0.9), truth(0.5), truth(0.1)));
    return {error <= 0.1 * bench.bound(48.0) && got.z < 0.0, textOf(got)};
}

Outcome nearTheNormal(Bench& bench)
{
    double worst = 0.0;
    for (const bool viewerNear : {true, false}) {
        Question question = rough("oren_nayar_full", 0.5);
        question.L = at(viewerNear ? 1.0 : 1e-6, 0.0);
        question.V = at(viewerNear ? 1e-6 : 1.0, 1.0);
        const double truth = fullOrenNayar(rho, 0.5, viewerNear ? 1.0 : 1e-6, viewerNear ? 1e-6 : 1.0, std::cos(1.0));
        worst = worse(worst, largestOf(bench.ask(question) - Vec3d(truth)) / truth);
    }
    return within(worst, bench.bound(0.0), "relative error");
}

Outcome grazingViewer(Bench& bench)
{
    Question question = rough("eon", 0.5);
    question.L = at(0.5, 0.0);
    question.V = {-1, 0, 1e-15};
    const Vec3d got = bench.ask(question);
    // E(0) = 1 leaves the single-scattering lobe alone; s = L.V = -sin(0.5) there.
    const double truth = rho * std::cos(0.5) * fujiiFactor(0.5) * (1.0 - 0.5 * std::sin(0.5));
    return within(largestOf(got - Vec3d(truth)) / truth, bench.bound(1.0), "relative error");
}

} // namespace

Hazards roughHazards()
{
    Hazards rows;
    for (const char* model : {"oren_nayar", "oren_nayar_full", "oren_nayar_fujii", "eon"})
        rows.push_back(
            {"H30",
             "no roughness",
             std::string(model) + ", sigma or r = 0, N.L from 1 to 8e-4",
             "Lambert to 4 units, no 0/0",
             inEveryPrecision,
             {model},
             smoothIsLambert(model),
             seen(lit(rough(model, 0.0), 0.9), "No roughness: the sphere is Lambert's, to the last bit or two.")});
    const auto noAzimuth = [&](const char* model, double (*expected)(double)) {
        rows.push_back(
            {"H31",
             "the azimuth undefined",
             std::string(model) + ", V = N; L = N",
             "no azimuth term",
             inEveryPrecision,
             {model},
             withoutAzimuth(model, expected),
             seen(lit(rough(model, 0.5), 0.8),
                  "The camera looks along N: the middle has no azimuth, and no spot, seam or hole shows there.")});
    };
    noAzimuth("oren_nayar", qualitativeFromN);
    noAzimuth("oren_nayar_full", fullFromN);
    noAzimuth("oren_nayar_fujii", fujiiFromN);
    rows.insert(
        rows.end(),
        {{"H32",
          "light and viewer both grazing",
          "oren_nayar, L = (1,0,g), V = (1,0,1.5g), g to 1e-15",
          "0.216 in the end, never 0 or infinite",
          inEveryPrecision,
          {"oren_nayar"},
          bothGrazing,
          seen(grazingBoth(0.1), "Light and viewer both graze the middle: a rough surface stays bright to its edge.")},
         {"H33",
          "sigma beyond the model",
          "oren_nayar, sigma = 2, 10, 1000, N = L = V",
          "0.9 (1 - 0.5 s^2/(s^2+0.33)), 0.45 in the end",
          inEveryPrecision,
          {"oren_nayar"},
          beyondTheModel,
          seen(lit(rough("oren_nayar", 10.0), 0.5), "sigma = 10: finite, though the model says little there.")},
         {"H34",
          "negative radiance",
          "oren_nayar_full, rho 0.9 0.5 0.1, sigma = 1, both at 1.55, azimuth 3",
          "the formula's value, negative in blue",
          inEveryPrecision,
          {"oren_nayar_full"},
          negativeRadiance,
          seen(forwardGrazing(),
               "The formula is negative in blue near the edge that faces the light's far side. The lens marks it.")},
         {"H35",
          "acos near the normal",
          "oren_nayar_full, L or V at 1e-6, the other at 1",
          "within 32 units",
          inEveryPrecision,
          {"oren_nayar_full"},
          nearTheNormal,
          seen(lit(rough("oren_nayar_full", 0.5), 1.0),
               "The camera looks along N: no ring, no noise about the middle. Put the lens over it.")},
         {"H36",
          "EON's albedo at the horizon",
          "eon, N.V = 1e-15",
          "E(0) = 1: the single lobe alone",
          inEveryPrecision,
          {"eon"},
          grazingViewer,
          seen(lit(rough("eon", 0.5), 0.5),
               "The sphere's edge is where N.V = 0: no bright or dark rim of pixels that are no numbers.")}});
    return rows;
}

} // namespace reflectance
