#include "core/study/fit/survey_page.h"

#include "core/base/text.h"
#include "core/math/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace reflectance {
namespace {

constexpr double tolerances[] = {0.05, 0.1, 0.2};

std::string percent(double share)
{
    return std::isfinite(share) ? general(100.0 * share, share < 0.0995 ? 2 : 3) + " %" : "-";
}

std::string row(const std::vector<std::string>& cells)
{
    return "| " + joined(cells, " | ") + " |\n";
}

std::string count(std::size_t number)
{
    return std::to_string(number);
}

struct Answer {
    std::array<std::size_t, 3> served{}; ///< by ServedBy
    std::size_t rescued = 0;             ///< of those that neither serves: served by another model
    [[nodiscard]] std::string by(ServedBy who) const { return count(served[static_cast<std::size_t>(who)]); }
};

Answer answerFor(const Survey& survey, double tolerance, const std::string& format = {})
{
    Answer answer;
    for (const SurveyedSurface& surface : survey.surfaces) {
        if (!format.empty() && surface.format != format)
            continue;
        const ServedBy who = servedBy(survey, surface, tolerance);
        ++answer.served[static_cast<std::size_t>(who)];
        answer.rescued += who == ServedBy::Neither && cheapestWithin(survey, surface, tolerance) ? 1 : 0;
    }
    return answer;
}

std::vector<std::string> formatsOf(const Survey& survey)
{
    std::vector<std::string> formats;
    for (const SurveyedSurface& surface : survey.surfaces)
        if (std::find(formats.begin(), formats.end(), surface.format) == formats.end())
            formats.push_back(surface.format);
    return formats;
}

std::string creditFor(const std::string& format)
{
    static const std::map<std::string, std::string> credits{
        {"CUReT",
         "Dana, van Ginneken, Nayar, Koenderink, Reflectance and Texture of Real-World Surfaces, ACM TOG 18(1), 1999"},
        {"Cornell BRDF", "Cornell University, Program of Computer Graphics"},
        {"RGL BSDF (rgb)",
         "Dupuy and Jakob, An Adaptive Parameterization for Efficient Material Acquisition and Rendering, "
         "ACM TOG 37(6), 2018; the data base is CC0"},
        {"RGL BSDF (spectra)", "Dupuy and Jakob, ACM TOG 37(6), 2018; the data base is CC0"}};
    const auto found = credits.find(format);
    return found == credits.end() ? "" : found->second;
}

std::string methodText(const Survey& survey)
{
    const FitOptions& options = survey.options;
    return "Each of the " + count(survey.candidates.size()) + " models was fitted to each of the " +
           count(survey.surfaces.size()) + " surfaces by least squares with " + std::string(nameOf(options.weighting)) +
           " weights on " +
           (options.cosine ? "pi f (N.L), what a light brings" : "pi f, the BRDF against a white diffuser's") +
           ", within each parameter's legal range, from up to " + std::to_string(options.starts) +
           " starts. Surfaces are taken without their colour (the mean of the channels): the question is how light is "
           "spread over directions. The *relative RMS error* is the root mean square of model minus measurement, over "
           "that of the measurement itself, at the directions that were measured; a model *serves* a surface when it "
           "is "
           "within the tolerance. What an instrument's own noise adds is part of every error.\n\n";
}

std::string answerText(const Survey& survey, double tolerance)
{
    const Answer answer = answerFor(survey, tolerance);
    const std::size_t neither = answer.served[static_cast<std::size_t>(ServedBy::Neither)];
    std::string text = "**Of " + count(survey.surfaces.size()) + " surfaces, within " + percent(tolerance) +
                       ", Lambert serves " + answer.by(ServedBy::Lambert) + ", the hybrid serves " +
                       answer.by(ServedBy::Hybrid) + " more, and " + count(neither) +
                       " are in the middle: served by neither.** ";
    if (neither > 0)
        text += "Of those, " + count(answer.rescued) + " are served by another model of the catalogue; for " +
                count(neither - answer.rescued) + " no model comes that near.";
    text += "\n\nHow strict one is decides much:\n\n" +
            row({"tolerance", "Lambert", "only the hybrid", "neither", "of those by another model"}) +
            row({"---", "---", "---", "---", "---"});
    for (const double other : tolerances) {
        const Answer a = answerFor(survey, other);
        text += row({percent(other), a.by(ServedBy::Lambert), a.by(ServedBy::Hybrid), a.by(ServedBy::Neither),
                     count(a.rescued)});
    }
    return text + "\n";
}

std::string dataText(const Survey& survey, double tolerance)
{
    std::string text = "By origin, within " + percent(tolerance) + ":\n\n" +
                       row({"data", "surfaces", "Lambert", "only the hybrid", "neither", "credit"}) +
                       row({"---", "---", "---", "---", "---", "---"});
    for (const std::string& format : formatsOf(survey)) {
        const Answer a = answerFor(survey, tolerance, format);
        text += row({format, count(a.served[0] + a.served[1] + a.served[2]), a.by(ServedBy::Lambert),
                     a.by(ServedBy::Hybrid), a.by(ServedBy::Neither), creditFor(format)});
    }
    return text + "\n";
}

std::string modelsText(const Survey& survey, double tolerance)
{
    std::string text =
        row({"model", "median error", "90 of 100 within", "serves", "best by BIC", "ns, double", "ns, SIMD"}) +
        row({"---", "---", "---", "---", "---", "---", "---"});
    for (std::size_t i = 0; i < survey.candidates.size(); ++i) {
        const FittedModel& candidate = survey.candidates[i];
        const std::vector<double> errors = errorsOf(survey, candidate.label);
        const auto error = [&](double share) { return errors.empty() ? HUGE_VAL : quantileOf(errors, share); };
        const auto within = std::count_if(errors.begin(), errors.end(), [&](double e) { return e <= tolerance; });
        const auto best = std::count_if(survey.surfaces.begin(), survey.surfaces.end(),
                                        [&](const SurveyedSurface& s) { return bestByBic(s) == std::optional(i); });
        text += row({"`" + candidate.label + "`", percent(error(0.5)), percent(error(0.9)),
                     count(static_cast<std::size_t>(within)), count(static_cast<std::size_t>(best)),
                     general(candidate.nsDouble, 3), general(candidate.nsSimd, 3)});
    }
    return text + "\n";
}

std::string errorCell(const Survey& survey, const SurveyedSurface& surface, std::string_view label)
{
    for (std::size_t i = 0; i < surface.fits.size(); ++i)
        if (survey.candidates[i].label == label && surface.fits[i])
            return percent(surface.fits[i]->relativeRms);
    return "-";
}

std::string surfacesText(const Survey& survey, double tolerance)
{
    std::string text = row({"surface", "samples", "Lambert", "hybrid", "best by BIC", "its error",
                            "cheapest within " + percent(tolerance)}) +
                       row({"---", "---", "---", "---", "---", "---", "---"});
    for (const SurveyedSurface& surface : survey.surfaces) {
        const auto best = bestByBic(surface);
        const auto cheapest = cheapestWithin(survey, surface, tolerance);
        text += row({surface.name, count(surface.samples), errorCell(survey, surface, "lambert"),
                     errorCell(survey, surface, "hybrid"), best ? "`" + survey.candidates[*best].label + "`" : "-",
                     best ? percent(surface.fits[*best]->relativeRms) : "-",
                     cheapest ? "`" + survey.candidates[*cheapest].label + "`" : "none"});
    }
    return text + "\n";
}

/// What writes the page anew: the weighting is part of the answer.
std::string commandFor(const FitOptions& options)
{
    return std::string("reflectance fit FOLDER... --all") + (options.cosine ? " --cosine" : "") +
           (options.weighting == Weighting::Logarithmic ? " --weights log" : "") + (options.robust ? " --robust" : "") +
           " --markdown real-surfaces.md";
}

} // namespace

std::string pageOf(const Survey& survey, double tolerance, const std::string& images)
{
    std::string text =
        "# Real surfaces\n\n"
        "The lecture asks whether hybrid reflectance describes real objects, and answers: yes for shiny ones, "
        "yes for perfectly matte ones, no for the surfaces in the middle. This page asks measurements. The "
        "program wrote it: `" +
        commandFor(survey.options) + "`, given folders with the measurements, writes it anew.\n\n## The answer\n\n" +
        answerText(survey, tolerance) + dataText(survey, tolerance);
    for (const Drawing& drawing : drawingsOf(survey, tolerance))
        text += "![" + drawing.says + "](" + images + drawing.name + ".svg)\n\n" + drawing.says + "\n\n";
    return text + "## How it was asked\n\n" + methodText(survey) + "## The models\n\n" + modelsText(survey, tolerance) +
           "BIC weighs the fit against the number of parameters, so a model with many has to earn them. Costs are this "
           "page's machine's: the best of several rounds with everything in the first-level cache.\n\n"
           "## The surfaces\n\n" +
           surfacesText(survey, tolerance);
}

} // namespace reflectance
