// The figures of `fit --all`.
#include "app/cli/fit_report.h"
#include "core/base/text.h"
#include "core/math/quantile.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(ServedBy served)
{
    return served == ServedBy::Lambert ? "lambert" : served == ServedBy::Hybrid ? "hybrid" : "neither";
}

std::size_t countBest(const Survey& survey, std::size_t candidate)
{
    return static_cast<std::size_t>(
        std::count_if(survey.surfaces.begin(), survey.surfaces.end(),
                      [&](const SurveyedSurface& s) { return bestByBic(s) == std::optional(candidate); }));
}

std::size_t countServed(const Survey& survey, ServedBy served, double tolerance)
{
    return static_cast<std::size_t>(
        std::count_if(survey.surfaces.begin(), survey.surfaces.end(),
                      [&](const SurveyedSurface& s) { return servedBy(survey, s, tolerance) == served; }));
}

Json labelOf(const Survey& survey, const std::optional<std::size_t>& candidate)
{
    return candidate ? Json(survey.candidates[*candidate].label) : Json(nullptr);
}

Json describedFits(const Survey& survey, const SurveyedSurface& surface)
{
    Json fits = Json::array();
    for (std::size_t i = 0; i < surface.fits.size(); ++i)
        if (const auto& fit = surface.fits[i])
            fits.push_back({{"model", survey.candidates[i].label},
                            {"relative_rms", fit->relativeRms},
                            {"aic", fit->aic},
                            {"bic", fit->bic},
                            {"parameters", fit->values},
                            {"warnings", fit->warnings}});
    return fits;
}

} // namespace

void print(const Survey& survey, double tolerance)
{
    std::printf("%-24s %10s %10s %12s %12s %12s\n", "model", "median", "within", "best by", "ns in", "ns in");
    std::printf("%-24s %10s %9.3g%% %12s %12s %12s\n", "", "rel. RMS", 100.0 * tolerance, "BIC", "double", "simd");
    for (std::size_t i = 0; i < survey.candidates.size(); ++i) {
        const FittedModel& candidate = survey.candidates[i];
        const std::vector<double> errors = errorsOf(survey, candidate.label);
        const auto within = std::count_if(errors.begin(), errors.end(), [&](double e) { return e <= tolerance; });
        std::printf("%-24s %9.3g%% %10zu %12zu %12.3g %12.3g\n", candidate.label.c_str(), 100.0 * medianOf(errors),
                    static_cast<std::size_t>(within), countBest(survey, i), candidate.nsDouble, candidate.nsSimd);
    }
    std::printf("\n%zu surfaces: within %.3g %%, Lambert serves %zu, only the hybrid %zu, neither %zu\n",
                survey.surfaces.size(), 100.0 * tolerance, countServed(survey, ServedBy::Lambert, tolerance),
                countServed(survey, ServedBy::Hybrid, tolerance), countServed(survey, ServedBy::Neither, tolerance));
    for (const std::string& sentence : survey.skipped)
        std::fprintf(stderr, "reflectance: left out: %s\n", sentence.c_str());
}

Json described(const Survey& survey, double tolerance)
{
    Json models = Json::array();
    for (const FittedModel& candidate : survey.candidates)
        models.push_back(
            {{"model", candidate.label}, {"ns_double", candidate.nsDouble}, {"ns_simd", candidate.nsSimd}});
    Json surfaces = Json::array();
    for (const SurveyedSurface& surface : survey.surfaces)
        surfaces.push_back({{"surface", surface.name},
                            {"format", surface.format},
                            {"samples", surface.samples},
                            {"served_by", nameOf(servedBy(survey, surface, tolerance))},
                            {"cheapest", labelOf(survey, cheapestWithin(survey, surface, tolerance))},
                            {"best_by_bic", labelOf(survey, bestByBic(surface))},
                            {"fits", describedFits(survey, surface)}});
    return {{"tolerance", tolerance},
            {"weights", reflectance::nameOf(survey.options.weighting)},
            {"cosine", survey.options.cosine},
            {"models", models},
            {"surfaces", surfaces},
            {"left_out", survey.skipped}};
}

std::string csvOf(const Survey& survey)
{
    std::string text = "surface,format,samples,model,relative_rms,rms,aic,bic,ns_double,ns_simd\n";
    for (const SurveyedSurface& surface : survey.surfaces)
        for (std::size_t i = 0; i < surface.fits.size(); ++i) {
            const FittedModel& candidate = survey.candidates[i];
            const auto& fit = surface.fits[i];
            if (!fit)
                continue;
            std::string label = candidate.label;
            std::replace(label.begin(), label.end(), ',', ' ');
            text += joined({surface.name, surface.format, std::to_string(surface.samples), label,
                            shortest(fit->relativeRms), shortest(fit->rms), shortest(fit->aic), shortest(fit->bic),
                            general(candidate.nsDouble, 4), general(candidate.nsSimd, 4)},
                           ",") +
                    "\n";
        }
    return text;
}

} // namespace reflectance::cli
