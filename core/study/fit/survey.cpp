#include "core/study/fit/survey.h"

#include "core/base/text.h"
#include "core/measured/load.h"
#include "core/study/cost/shading_cost.h"
#include "core/study/crew/ranks.h"
#include "core/study/fit/survey_run.h"

#include <algorithm>
#include <filesystem>
#include <limits>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

struct Source {
    std::string path;
    bool isNamed = false; ///< by the user, so that it must be a measured surface
};

Result<std::vector<Source>> sourcesIn(const std::vector<std::string>& paths)
{
    std::vector<Source> sources;
    for (const std::string& path : paths) {
        std::error_code failed;
        if (!fs::is_directory(path, failed)) {
            sources.push_back({path, true});
            continue;
        }
        const std::size_t before = sources.size();
        for (const auto& entry : fs::recursive_directory_iterator(path, failed))
            if (entry.is_regular_file(failed))
                sources.push_back({entry.path().string(), false});
        if (failed)
            return Error{"cannot be read: " + failed.message(), path};
        std::sort(sources.begin() + static_cast<std::ptrdiff_t>(before), sources.end(),
                  [](const Source& a, const Source& b) { return a.path < b.path; });
    }
    return sources;
}

/// CUReT is two files; the surfaces are counted where the geometries are.
bool isOtherHalf(const Source& source)
{
    return !source.isNamed && fs::path(source.path).filename() == "table.txt" &&
           fs::exists(fs::path(source.path).parent_path() / "abrdf.dat");
}

SurveySubject subjectOf(const Measurement& measurement, const std::string& path, std::size_t number)
{
    const Provenance& provenance = provenanceOf(measurement);
    SurveySubject subject{{}, greyOf(observationsOf(measurement))};
    subject.surface.name = fs::path(path).stem().string();
    if (provenance.surfaces > 1)
        subject.surface.name += " " + std::to_string(number);
    subject.surface.format = provenance.format;
    subject.surface.samples = subject.data.rows.size();
    subject.data.name = subject.surface.name;
    return subject;
}

Result<std::vector<SurveySubject>> subjectsIn(const Source& source)
{
    std::vector<SurveySubject> subjects;
    std::size_t count = 1;
    for (std::size_t number = 1; number <= count; ++number) {
        const auto measurement = loadMeasurement(source.path, {number, {}});
        if (!measurement)
            return measurement.error();
        count = provenanceOf(*measurement).surfaces;
        subjects.push_back(subjectOf(*measurement, source.path, number));
    }
    return subjects;
}

Result<std::vector<SurveySubject>> collect(const std::vector<std::string>& paths, std::vector<std::string>& skipped)
{
    const auto sources = sourcesIn(paths);
    if (!sources)
        return sources.error();
    std::vector<SurveySubject> subjects;
    for (const Source& source : *sources) {
        if (isOtherHalf(source))
            continue;
        auto found = subjectsIn(source);
        if (!found && source.isNamed)
            return found.error();
        if (!found)
            skipped.push_back(found.error().sentence());
        else
            std::move(found->begin(), found->end(), std::back_inserter(subjects));
    }
    if (subjects.empty())
        return Error{"holds no measured surface", joined(paths)};
    return subjects;
}

/// Where there is no colour, a model in colour is the same model again.
bool repeatsAnEarlierModel(const ModelText& model)
{
    return model.id == "lambert_color";
}

/// To a measurement without colour: it knows no size of lights, and there has to be a number to find.
bool canBeFitted(const ModelText& model)
{
    return !model.usesLightSize && !variablesOf(model, ObservedForm::Grey, {}, {}).empty();
}

/// One candidate per choice that the model offers.
void addCandidates(const Model& model, std::vector<FittedModel>& candidates)
{
    for (const Parameter& p : model.text.parameters)
        if (p.kind == ParameterKind::Choice) {
            for (const double choice : p.choices)
                candidates.push_back(
                    {model.id() + ", " + p.name + " " + shortest(choice), &model, {{p.name, {choice}}}, 0.0, 0.0});
            return;
        }
    candidates.push_back({model.id(), &model, {}, 0.0, 0.0});
}

} // namespace

std::vector<FittedModel> candidatesOfCatalogue()
{
    std::vector<FittedModel> candidates;
    for (const Model& model : catalogue()) {
        if (canBeFitted(model.text) && !repeatsAnEarlierModel(model.text))
            addCandidates(model, candidates);
    }
    return candidates;
}

void measureCosts(std::vector<FittedModel>& candidates)
{
    for (FittedModel& candidate : candidates) {
        const std::vector<double> flat = flatValues(candidate.model->text, candidate.fixed);
        candidate.nsDouble = shadingCost(*candidate.model, flat, Precision::Double);
        candidate.nsSimd = shadingCost(*candidate.model, flat, Precision::Simd);
    }
}

Result<Survey> survey(const std::vector<std::string>& paths, const FitOptions& options, Progress* progress,
                      const SurveyRun& run)
{
    Survey result{options, candidatesOfCatalogue(), {}, {}};
    if (run.own && !canBeFitted(run.own->text))
        return Error{"has no parameter that a measured surface could determine", run.own->text.file};
    if (run.own)
        addCandidates(*run.own, result.candidates);
    if (!isHelper())
        measureCosts(result.candidates);
    auto subjects = collect(paths, result.skipped);
    if (!subjects)
        return subjects.error();
    if (const auto fitted = fitAll(result, *std::move(subjects), run, progress); !fitted)
        return fitted.error();
    return result;
}

std::optional<std::size_t> cheapestWithin(const Survey& survey, const SurveyedSurface& surface, double tolerance)
{
    std::optional<std::size_t> cheapest;
    for (std::size_t i = 0; i < surface.fits.size(); ++i)
        if (surface.fits[i] && surface.fits[i]->relativeRms <= tolerance &&
            (!cheapest || survey.candidates[i].nsSimd < survey.candidates[*cheapest].nsSimd))
            cheapest = i;
    return cheapest;
}

std::optional<std::size_t> bestByBic(const SurveyedSurface& surface)
{
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < surface.fits.size(); ++i)
        if (surface.fits[i] && (!best || surface.fits[i]->bic < surface.fits[*best]->bic))
            best = i;
    return best;
}

ServedBy servedBy(const Survey& survey, const SurveyedSurface& surface, double tolerance)
{
    const auto serves = [&](const char* label) {
        for (std::size_t i = 0; i < surface.fits.size(); ++i)
            if (survey.candidates[i].label == label)
                return surface.fits[i] && surface.fits[i]->relativeRms <= tolerance;
        return false;
    };
    return serves("lambert") ? ServedBy::Lambert : serves("hybrid") ? ServedBy::Hybrid : ServedBy::Neither;
}

std::vector<double> errorsOf(const Survey& survey, const std::string& label)
{
    std::vector<double> errors;
    for (const SurveyedSurface& surface : survey.surfaces)
        for (std::size_t i = 0; i < surface.fits.size(); ++i)
            if (survey.candidates[i].label == label)
                errors.push_back(surface.fits[i] ? surface.fits[i]->relativeRms
                                                 : std::numeric_limits<double>::infinity());
    return errors;
}

} // namespace reflectance
