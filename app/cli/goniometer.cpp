// `goniometer`: a micro-surface, measured from all lighting and viewing directions into a table.
#include "app/cli/chosen_model.h"
#include "app/cli/goniometer_report.h"
#include "app/cli/launched.h"
#include "app/cli/long_work.h"
#include "app/cli/page.h"
#include "app/cli/report.h"
#include "app/cli/table_options.h"
#include "app/cli/verbs.h"
#include "core/base/digest.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/study/crew/ranks.h"
#include "core/study/goniometer/checkpoint.h"
#include "core/study/goniometer/groove_study.h"
#include "core/study/goniometer/lab_crew.h"
#include "core/study/goniometer/lobe_charts.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct Options {
    std::string surface;
    ModelChoice model{"lambert"};
    std::vector<std::string> assignments, without;
    int bounces = 0;
    std::string grid = "isotropic:10x13";
    std::optional<double> azimuth;
    std::uint64_t seed = 1;
    long samples = 4096;
    unsigned workers = 0;
    std::optional<double> error, seconds;
    std::string out, errors, resume, json, plot, study;
    std::optional<double> thetaI;
    std::string against;
    std::vector<std::string> againstValues;
    std::vector<std::string> setupFlags; ///< those given that --resume takes from its file
};

/// A run with what it is traced on.
struct Bench {
    LabRun run;
    MicroSurface surface;
    std::shared_ptr<const Model> model;
    Facets facets; ///< of that model
};

/// Of all that a run's numbers depend on beside what its file spells out: the surface, and the text of an own model.
std::uint64_t fingerprintOf(const MicroSurface& surface, const Model& model, const ModelChoice& choice)
{
    const std::string text = choice.file.empty() ? "" : digestOf(model.text.code);
    return surface.fingerprint() ^ (text.empty() ? 0 : std::stoull(text, nullptr, 16));
}

Result<GridShape> gridFor(const Options& options)
{
    auto shape = parseGrid(options.grid);
    if (!shape)
        return shape;
    if (shape->system != AngleSystem::Isotropic)
        return Error{"--grid " + options.grid +
                     ": a goniometer turns about theta_i, theta_r and delta_phi; write isotropic:THETASxPHIS"};
    return options.azimuth ? labShape(shape->axes[0].size(), shape->axes[2].size(), false) : shape;
}

Result<Bench> benchFromFlags(const Options& options)
{
    const auto model = chosenModel(options.model);
    if (!model)
        return model.error();
    const auto values = valuesFrom((*model)->text, options.assignments, "--set");
    if (!values)
        return values.error();
    const auto facets = facetsOf(**model, *values);
    if (!facets)
        return facets.error();
    const auto shape = gridFor(options);
    if (!shape)
        return shape.error();
    const auto surface = microSurface(options.surface);
    if (!surface)
        return surface.error();
    LabSetup setup;
    setup.surface = options.surface;
    setup.model = (*model)->id();
    setup.values = *values;
    setup.channels = facets->channels;
    setup.effects.bounces = options.bounces;
    for (const std::string& effect : options.without)
        (effect == "masking" ? setup.effects.masking : setup.effects.shadowing) = false;
    if (options.azimuth)
        setup.azimuth = radians(*options.azimuth);
    setup.shape = *shape;
    setup.seed = options.seed;
    const std::uint64_t fingerprint = fingerprintOf(*surface, **model, options.model);
    return Bench{startedRun(std::move(setup), fingerprint), *surface, *model, *facets};
}

/// The run of a file, on the same surface as then.
Result<Bench> benchFromFile(const Options& options)
{
    if (!options.surface.empty() || !options.setupFlags.empty())
        return Error{"--resume takes the surface, the facets, the grid and the seed from its file; leave " +
                     (options.setupFlags.empty() ? options.surface : options.setupFlags.front()) + " away"};
    const auto text = readWholeFile(options.resume);
    if (!text)
        return text.error();
    auto run = readCheckpoint(*text, options.resume);
    if (!run)
        return run.error();
    const auto model = chosenModel({run->setup.model, options.model.file});
    if (!model && options.model.file.empty())
        return Error{model.error().message + "; where it was a model of your own, name it with --model-file",
                     options.resume};
    if (!model)
        return model.error();
    if ((*model)->id() != run->setup.model)
        return Error{"was measured with facets of " + run->setup.model + ", not of " + (*model)->id(), options.resume};
    if (run->setup.values.size() != (*model)->text.valueCount())
        return Error{"holds " + std::to_string(run->setup.values.size()) + " values where the model " +
                         run->setup.model + " has " + std::to_string((*model)->text.valueCount()) + "; begin a new run",
                     options.resume};
    const auto facets = facetsOf(**model, run->setup.values);
    if (!facets)
        return Error{facets.error().message, options.resume};
    const auto surface = microSurface(run->setup.surface);
    if (!surface)
        return surface.error();
    if (fingerprintOf(*surface, **model, options.model) != run->fingerprint || facets->channels != run->setup.channels)
        return Error{"was measured on another " + run->setup.surface + " or with another text of " + run->setup.model +
                         " than there is now; begin a new run",
                     options.resume};
    return Bench{*std::move(run), *surface, *model, *facets};
}

/// What can be refused before hours of tracing.
Result<void> checkedTargets(const Options& options)
{
    if (options.samples < 1)
        return Error{"--samples " + std::to_string(options.samples) + ": at least one path per cell is needed"};
    if (options.samples > (1L << 24))
        return Error{"--samples " + std::to_string(options.samples) + ": at most 16777216 paths per cell are possible"};
    if (options.error && !(*options.error > 0.0))
        return Error{"--error " + general(*options.error, 6) + ": a standard error must be above 0"};
    if (options.seconds && !(*options.seconds > 0.0))
        return Error{"--seconds " + general(*options.seconds, 6) + ": a time must be above 0"};
    return {};
}

Result<TableFormat> checkedOutputs(const Options& options, const Bench& bench)
{
    auto format = tableFormatOf(options.out);
    if (!format)
        return format.error();
    Table table;
    table.system = AngleSystem::Isotropic;
    table.channels = bench.run.setup.channels;
    if (const auto holds = checkHolds(*format, table); !holds)
        return Error{holds.error().message, options.out};
    for (const std::string& file : {options.out, options.errors, options.plot, options.json})
        if (!file.empty() && file != "-")
            if (const auto writable = checkWritable(file); !writable)
                return writable.error();
    if (options.errors.empty())
        return format;
    const auto errors = tableFormatOf(options.errors);
    return errors ? format : errors;
}

std::string checkpointOf(const Options& options)
{
    return options.resume.empty() ? options.out + ".lab" : options.resume;
}

/// Measures; the file of the run is renewed on the way, and always at the end.
Result<LabFailures> measureWatched(Bench& bench, const Options& options)
{
    constexpr std::chrono::seconds between{20};
    const MicroTracer tracer(bench.surface, bench.facets, bench.run.setup.effects);
    LabTargets targets;
    targets.paths = static_cast<std::uint64_t>(options.samples);
    targets.error = options.error;
    targets.seconds = options.seconds;
    auto saved = std::chrono::steady_clock::now();
    Result<void> written;
    const LongWork work;
    const auto watch = [&](const LabRun& run) {
        if (std::chrono::steady_clock::now() - saved < between)
            return;
        written = writeAtomically(checkpointOf(options), checkpointText(run));
        saved = std::chrono::steady_clock::now();
    };
    auto measured = measureWithCrew(bench.run, tracer, targets, options.workers, &LongWork::progress(), watch);
    if (isHelper())
        return measured;
    if (auto last = writeAtomically(checkpointOf(options), checkpointText(bench.run)); !last)
        return last.error();
    return !measured || written ? measured : Result<LabFailures>(written.error());
}

/// Cells of which processes died.
void print(const LabFailures& failures)
{
    for (const auto& [cell, why] : failures)
        std::cerr << "reflectance: cell " << cell << " could not be measured any further: " << why << '\n';
}

Result<std::optional<NamedFactor>> rivalFrom(const Options& options)
{
    if (options.against.empty())
        return std::optional<NamedFactor>();
    const auto model = findModel(options.against);
    if (!model)
        return Error{"--against: " + model.error().message};
    const auto values = valuesFrom((*model)->text, options.againstValues, "--with");
    if (!values)
        return values.error();
    return std::optional(NamedFactor{(*model)->text.name, factorOf(**model, *values)});
}

Result<void> writeResults(const Bench& bench, const Options& options, TableFormat format,
                          const std::optional<NamedFactor>& rival)
{
    if (auto saved = saveTable(options.out, format, tableOf(bench.run)); !saved)
        return saved;
    if (!options.errors.empty())
        if (auto saved = saveTable(options.errors, *tableFormatOf(options.errors), errorsOf(bench.run)); !saved)
            return saved;
    if (!options.plot.empty()) {
        const std::size_t incidence = nearestIncidence(bench.run.setup, radians(options.thetaI.value_or(60.0)));
        const std::vector<NamedFactor> formulas = rival ? std::vector{*rival} : std::vector<NamedFactor>();
        const Chart chart = planeChart(bench.run, "traced", incidence, formulas);
        if (auto saved = writeAtomically(options.plot, svgOf(chart, 760, 460)); !saved)
            return saved;
    }
    std::optional<Compared> compared;
    if (rival)
        compared = Compared{rival->name, gapBetween(bench.run, rival->factor)};
    if (options.json != "-")
        print(bench.run, bench.surface, compared);
    return writeReport(options.json, described(bench.run, bench.surface, compared));
}

int runStudy(const Options& options)
{
    if (const auto writable = checkWritable(options.study); !writable)
        return refused(writable.error());
    const auto study = [&] {
        const LongWork work;
        LabTargets targets;
        targets.paths = static_cast<std::uint64_t>(options.samples);
        targets.error = options.error;
        return studyGrooves({10.0, 20.0, 30.0, 40.0}, 0.9, 10, targets, &LongWork::progress());
    }();
    if (!study)
        return LongWork::wasStopped() ? refused(study.error(), Stopped) : refused(study.error());
    const std::string command =
        "reflectance goniometer --study " + options.study + " --samples " + std::to_string(options.samples);
    const auto written = writePage(options.study, drawingsOf(*study),
                                   [&](const std::string& images) { return pageOf(*study, images, command); });
    return written ? Done : refused(written.error());
}

int run(const Options& options)
{
    if (const auto code = refusedLaunch())
        return *code;
    if (const auto targets = checkedTargets(options); !targets)
        return refused(targets.error());
    if (!options.study.empty())
        return isHelper() ? Done : runStudy(options); // on one machine
    if (options.surface.empty() && options.resume.empty())
        return refused(
            Error{"name a micro-surface, as vgrooves:sigma=30, or a run to go on with by --resume FILE.lab"});
    if (options.out.empty())
        return refused(Error{"name the table to write with --out FILE.csv, .json or .xompt"});
    const auto rival = rivalFrom(options);
    if (!rival)
        return refused(rival.error());
    auto bench = options.resume.empty() ? benchFromFlags(options) : benchFromFile(options);
    if (!bench)
        return refusedHere(bench.error(), BadInput);
    const auto format = checkedOutputs(options, *bench);
    if (!format)
        return refused(format.error());
    const auto measured = measureWatched(*bench, options);
    if (!measured)
        return refusedHere(measured.error(), BadInput);
    if (isHelper())
        return Done;
    if (LongWork::wasStopped()) {
        std::cerr << "reflectance: stopped after " << bench->run.paths()
                  << " paths; go on with 'reflectance goniometer --resume " << checkpointOf(options) << " --out "
                  << options.out << "'\n";
        return Stopped;
    }
    print(*measured);
    if (const auto written = writeResults(*bench, options, *format, *rival); !written)
        return refused(written.error());
    return measured->empty() ? Done : DoesNotHold;
}

void addSetupFlags(CLI::App& verb, const std::shared_ptr<Options>& options)
{
    verb.add_option(
        "surface", options->surface,
        "flat, vgrooves:slope=DEG or :sigma=DEG, gaussian:sigma=DEG,correlation=C, scratches:sigma=DEG,correlation=C, "
        "a picture of heights FILE.png:height=H (.exr, .pfm, .hdr), or a mesh");
    const auto model = addModelChoice(verb, options->model, "reflectance model of the facets");
    const std::vector<CLI::Option*> setup{
        model[0], // the file of an own one is given again when a run is resumed
        verb.add_option("--set", options->assignments, "name=value of the facets' model; may be repeated"),
        verb.add_option("--bounces", options->bounces,
                        "most reflections from facet to facet before the last; 0: single reflection")
            ->check(CLI::Range(0, mostBounces))
            ->capture_default_str(),
        verb.add_option("--without", options->without, "leave out masking or shadowing, to see what it contributes")
            ->check(CLI::IsMember({"masking", "shadowing"})),
        verb.add_option("--grid", options->grid,
                        "isotropic:THETASxPHIS, even steps from 0 to 90 and from 0 to 180 degrees")
            ->capture_default_str(),
        verb.add_option(
                "--azimuth", options->azimuth,
                "degrees by which the surface lies turned; without it the table is an isotropic mixture of all angles")
            ->check(CLI::Range(-360.0, 360.0)),
        verb.add_option("--seed", options->seed, "of the random paths")->capture_default_str()};
    verb.preparse_callback([options](std::size_t) { options->setupFlags.clear(); });
    for (CLI::Option* option : setup)
        option->each([options, name = option->get_name()](const std::string&) { options->setupFlags.push_back(name); });
}

} // namespace

void addGoniometer(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand(
        "goniometer",
        "The virtual laboratory: traces a micro-surface from all lighting and viewing directions into a table");
    addSetupFlags(*verb, options);
    verb->add_option("--samples", options->samples, "paths per cell, in batches of 256, at least four of them")
        ->capture_default_str();
    verb->add_option("--error", options->error,
                     "refine until no cell's standard error is above this share of the rms of f: 0.01");
    verb->add_option("--seconds", options->seconds,
                     "stop after this time; without --error the cells with the largest errors are refined until then");
    verb->add_option("--workers", options->workers, "processes that trace, under mpirun in every rank; 0: one per core")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    verb->add_option("--resume", options->resume,
                     "go on with a run: the .lab file that every run leaves beside its table");
    verb->add_option("--out", options->out, "the table: .csv, or .json or .xompt (OpenMATERIAL 3D)");
    verb->add_option("--errors", options->errors, "the standard errors of f as a table of the same grid");
    verb->add_option("--against", options->against,
                     "a model to compare the table with: rms gap, and a line in the plot");
    verb->add_option("--with", options->againstValues, "name=value of that model; may be repeated");
    verb->add_option("--plot", options->plot, "the plane of incidence with error bars (.svg)");
    verb->add_option("--theta-i", options->thetaI, "degrees: the light of the plot; the grid's nearest is taken")
        ->check(CLI::Range(0.0, 90.0));
    verb->add_option("--study", options->study,
                     "instead of a table, a page (.md) with plots: Oren and Nayar's formula against traced grooves");
    verb->add_option("--json", options->json, "all figures, to a file or - for standard output");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
