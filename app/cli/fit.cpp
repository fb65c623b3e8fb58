// `fit`: the parameters with which a model comes nearest to a measured table or to the pixels of a picture; `--all`: every model
// on many surfaces.
#include "app/cli/chosen_model.h"
#include "app/cli/fit_report.h"
#include "app/cli/launched.h"
#include "app/cli/long_work.h"
#include "app/cli/page.h"
#include "app/cli/report.h"
#include "app/cli/verbs.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/measured/load.h"
#include "core/scene/scene_file.h"
#include "core/study/crew/ranks.h"
#include "core/study/fit/picture_observations.h"
#include "core/study/fit/plane_chart.h"
#include "core/study/fit/survey_page.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct Options {
    std::vector<std::string> inputs;
    ModelChoice model;
    std::string weights = "linear";
    bool cosine = false, robust = false;
    int starts = FitOptions().starts;
    std::vector<std::string> fixed, grey;
    std::size_t surface = 1;
    std::optional<double> wavelength;
    std::string picture, scene;
    std::vector<std::string> pixels;
    std::string out, json, plot;
    std::optional<double> thetaI;
    bool all = false;
    double tolerance = 0.1;
    std::string csv, markdown;
    SurveyRun run;
};

Result<void> checkedNames(const ModelText& model, const std::vector<std::string>& names)
{
    for (const std::string& name : names)
        if (!model.find(name))
            return Error{"--grey " + name + ": model " + model.id + " has no such parameter"};
    return {};
}

Result<FitOptions> fitOptionsFrom(const Options& options, const ModelText* model)
{
    FitOptions result;
    result.weighting = options.weights == "log" ? Weighting::Logarithmic : Weighting::Linear;
    result.cosine = options.cosine;
    result.robust = options.robust;
    result.starts = options.starts;
    result.grey = {options.grey.begin(), options.grey.end()};
    if (!model)
        return result;
    if (const auto known = checkedNames(*model, options.grey); !known)
        return known.error();
    for (const std::string& assignment : options.fixed)
        if (const auto set = setParameter(*model, assignment, result.fixed); !set)
            return Error{"--fix " + assignment + ": " + set.error().message};
    return result;
}

Result<std::vector<PixelPlace>> pixelsFrom(const std::vector<std::string>& texts)
{
    std::vector<PixelPlace> pixels;
    for (const std::string& text : texts) {
        const auto parts = split(text, ',');
        const auto x = parseInteger(parts[0]);
        const auto y = parts.size() == 2 ? parseInteger(parts[1]) : std::nullopt;
        if (!x || !y || std::abs(*x) > 1000000 || std::abs(*y) > 1000000)
            return Error{"--pixel " + text + ": write COLUMN,ROW, counted from the upper left"};
        pixels.push_back({static_cast<int>(*x), static_cast<int>(*y)});
    }
    return pixels;
}

/// What the fit looks at, and the scene into which its surface goes.
struct Subject {
    Observations observations;
    Scene scene = defaultScene();
    std::optional<Measurement> measurement = {};
};

Result<Subject> subjectFromPicture(const Options& options)
{
    if (options.scene.empty())
        return Error{"--pixels needs --scene SCENE.json: the mesh, camera and lights of the picture"};
    const auto pixels = pixelsFrom(options.pixels);
    if (!pixels)
        return pixels.error();
    const auto picture = readPicture(options.picture);
    if (!picture)
        return picture.error();
    auto scene = loadScene(options.scene);
    if (!scene)
        return scene.error();
    auto observations = observationsOf(*picture, *scene, *pixels);
    if (!observations)
        return Error{observations.error().message, options.picture};
    observations->name = options.picture;
    return Subject{*std::move(observations), *std::move(scene)};
}

Result<Subject> subjectFrom(const Options& options)
{
    if (!options.picture.empty())
        return options.plot.empty()
                   ? subjectFromPicture(options)
                   : Result<Subject>(Error{"--plot shows a measured table; leave it or --pixels away"});
    if (options.inputs.size() != 1)
        return Error{"give one measured table, or a picture with --pixels, or files and folders with --all"};
    const auto measurement = loadMeasurement(options.inputs[0], {options.surface, options.wavelength});
    if (!measurement)
        return measurement.error();
    Subject subject;
    subject.observations = observationsOf(*measurement);
    subject.measurement = *measurement;
    return subject;
}

Result<void> checkedOutputs(const Options& options)
{
    for (const std::string& file : {options.out, options.json, options.plot, options.csv, options.markdown})
        if (!file.empty() && file != "-")
            if (auto writable = checkWritable(file); !writable)
                return writable;
    return {};
}

Result<FitResult> fitWatched(const Model& model, const Observations& observations, const FitOptions& options)
{
    const LongWork work;
    return fitModel(model, observations, options, &LongWork::progress());
}

int ended(const Error& error)
{
    return LongWork::wasStopped() ? Stopped : refusedHere(error, BadInput);
}

/// The fitted curve over the measurement.
Result<void> writePlot(const Options& options, const Model& model, const Subject& subject, const FitResult& fit)
{
    if (options.plot.empty())
        return {};
    const Measurement& measurement = *subject.measurement;
    const double thetaI = options.thetaI ? radians(*options.thetaI) : usualIncidence(measurement);
    const Chart chart = chartInPlane(measurement, model, flatValues(model.text, fit.values), thetaI, options.cosine);
    return writeAtomically(options.plot, svgOf(chart, 760, 460));
}

int fitOne(const Options& options)
{
    const auto model = chosenModel(options.model);
    if (!model)
        return refused(model.error());
    const auto fitOptions = fitOptionsFrom(options, &(*model)->text);
    if (!fitOptions)
        return refused(fitOptions.error());
    auto subject = subjectFrom(options);
    if (!subject)
        return refused(subject.error());
    const auto fit = fitWatched(**model, subject->observations, *fitOptions);
    if (!fit)
        return ended(fit.error());
    if (options.json != "-")
        print(**model, subject->observations, *fit, *fitOptions);
    if (const auto written = writeReport(options.json, described(**model, subject->observations, *fit, *fitOptions));
        !written)
        return refused(written.error());
    if (const auto written = writePlot(options, **model, *subject, *fit); !written)
        return refused(written.error());
    if (options.out.empty())
        return Done;
    Surface& surface = subject->scene.surface;
    surface.model = (*model)->id();
    if (!options.model.file.empty()) {
        surface.own = *model;
        surface.modelFile = options.model.file;
    }
    for (const auto& [name, numbers] : fit->values)
        surface.values[name] = numbers;
    const auto saved = saveScene(subject->scene, options.out);
    return saved ? Done : refused(saved.error());
}

int fitAll(const Options& options)
{
    if (const auto code = refusedLaunch())
        return *code;
    if ((options.model.isGiven && options.model.file.empty()) || !options.picture.empty() || !options.out.empty() ||
        !options.fixed.empty())
        return refused(Error{"--all fits every model; leave --model, --fix, --pixels and --out away"});
    if (options.inputs.empty())
        return refused(Error{"--all needs files or folders of measured surfaces"});
    const auto fitOptions = fitOptionsFrom(options, nullptr);
    if (!fitOptions)
        return refused(fitOptions.error());
    SurveyRun surveyRun = options.run;
    if (!options.model.file.empty()) {
        auto own = chosenModel(options.model);
        if (!own)
            return refused(own.error());
        surveyRun.own = *std::move(own);
    }
    const auto found = [&] {
        const LongWork work;
        return survey(options.inputs, *fitOptions, &LongWork::progress(), surveyRun);
    }();
    if (!found)
        return ended(found.error());
    if (isHelper())
        return Done;
    if (options.json != "-")
        print(*found, options.tolerance);
    if (const auto written = writeReport(options.json, described(*found, options.tolerance)); !written)
        return refused(written.error());
    if (!options.csv.empty())
        if (const auto written = writeAtomically(options.csv, csvOf(*found)); !written)
            return refused(written.error());
    if (!options.markdown.empty())
        if (const auto written =
                writePage(options.markdown, drawingsOf(*found, options.tolerance),
                          [&](const std::string& images) { return pageOf(*found, options.tolerance, images); });
            !written)
            return refused(written.error());
    return Done;
}

int run(const Options& options)
{
    if (const auto writable = checkedOutputs(options); !writable)
        return refused(writable.error());
    return options.all ? fitAll(options) : fitOne(options);
}

void addSubjectFlags(CLI::App& verb, Options& options)
{
    verb.add_option(
        "input", options.inputs,
        "measured table (CSV, OpenMATERIAL 3D, MERL, RGL, Cornell, CUReT, Zemax); with --all files and folders");
    verb.add_option("--surface", options.surface, "which one of a file that holds several, counted from 1")
        ->capture_default_str();
    verb.add_option("--wavelength", options.wavelength, "nm: this one of a spectral table instead of its colour");
    verb.add_option("--pixels", options.picture,
                    "fit the pixels of this picture (PNG, EXR, PFM, HDR) instead of a table");
    verb.add_option("--scene", options.scene, "the picture's scene (.json): its mesh, camera, lights and sensor");
    verb.add_option("--pixel", options.pixels,
                    "COLUMN,ROW of a pixel to use; without any, all that show the object lit");
}

void addFitFlags(CLI::App& verb, Options& options)
{
    addModelChoice(verb, options.model, "reflectance model to fit");
    verb.add_option("--weights", options.weights,
                    "linear: differences count as they are; log: dark and bright angles count alike")
        ->check(CLI::IsMember({"linear", "log"}))
        ->capture_default_str();
    verb.add_flag("--cosine", options.cosine, "compare pi f (N.L), what a light brings, instead of pi f");
    verb.add_flag("--robust", options.robust, "outliers count with their root only (Huber)");
    verb.add_option("--starts", options.starts, "from how many points to search")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    verb.add_option("--fix", options.fixed, "NAME=VALUE: a parameter that keeps this value");
    verb.add_option("--grey", options.grey, "a colour parameter that keeps one number for all channels");
}

void addSurveyFlags(CLI::App& verb, Options& options)
{
    verb.add_flag(
        "--all", options.all,
        "every model, and that of --model-file, on every surface of the files and folders, without their colour");
    verb.add_option("--tolerance", options.tolerance, "relative RMS error within which a model serves a surface")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    verb.add_option("--csv", options.csv, "with --all: a line per surface and model");
    verb.add_option("--markdown", options.markdown, "with --all: a page with plots");
    verb.add_option("--resume", options.run.journal,
                    "with --all: a file that keeps every fit as it is done, and from which the same command goes on");
    verb.add_option("--workers", options.run.workers,
                    "with --all: processes with a fit at a time, under mpirun in every rank; 0: one per core")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
}

} // namespace

void addFit(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand(
        "fit",
        "The parameters with which a model comes nearest to a measured table or a picture, with standard errors, "
        "residuals, and a warning where the data do not determine them");
    addSubjectFlags(*verb, *options);
    addFitFlags(*verb, *options);
    addSurveyFlags(*verb, *options);
    verb->add_option("--plot", options->plot,
                     "the fitted curve over a table's values in the plane of incidence (.svg)");
    verb->add_option("--theta-i", options->thetaI, "degrees: the light of the plot")->check(CLI::Range(0.0, 89.0));
    verb->add_option("--out", options->out, "a scene (.json) with the fitted surface");
    verb->add_option("--json", options->json, "all figures, to a file or - for standard output");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
