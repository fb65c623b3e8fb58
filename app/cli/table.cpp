// `table`: measured tables, described, made from models, and brought from one format to another.
#include "app/cli/chosen_model.h"
#include "app/cli/report.h"
#include "app/cli/table_info.h"
#include "app/cli/table_options.h"
#include "app/cli/verbs.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/study/tables/sample_model.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct SampleOptions {
    ModelChoice model;
    std::vector<std::string> assignments;
    std::string out;
    std::string json;
    GridOptions grid;
};

struct ConvertOptions {
    SourceOptions source;
    std::string out;
    std::string json;
    GridOptions grid;
};

nlohmann::ordered_json described(const ResamplingError& error)
{
    return {{"rms", error.rms}, {"worst", error.worst}, {"compared", error.compared}, {"lost", error.lost}};
}

/// What was written and how far it is from what it was made from.
int reported(const std::string& out, const std::string& json, const Table& table, const ResamplingError* error)
{
    nlohmann::ordered_json report{
        {"file", out}, {"grid", nameOf(table.system)}, {"channels", table.channels}, {"samples", table.samples()}};
    if (error)
        report["error"] = described(*error);
    if (json != "-")
        std::cout << out << ": " << shapeText(table) << ", " << table.channels
                  << (table.channels == 1 ? " channel" : " channels")
                  << (error ? "; error of the grid: " + sentenceOf(*error) : "; every sample as it was") << '\n';
    const auto written = writeReport(json, report);
    return written ? Done : refused(written.error());
}

/// The grid asked for, else the one that suits.
Result<GridShape> shapeFor(const GridOptions& options, const GridShape& suited)
{
    return options.grid.empty() ? Result(suited) : parseGrid(options.grid);
}

int runSample(const SampleOptions& options)
{
    const auto model = chosenModel(options.model);
    if (!model)
        return refused(model.error());
    const auto values = valuesFrom((*model)->text, options.assignments, "--set");
    if (!values)
        return refused(values.error());
    const auto format = tableFormatOf(options.out);
    if (!format)
        return refused(format.error());
    const bool isCsv = *format == TableFormat::Csv;
    const auto shape = shapeFor(options.grid, isCsv ? isotropicShape(31, 37) : naturalShape(*format));
    if (!shape)
        return refused(shape.error());
    if (const auto writable = checkWritable(options.out); !writable)
        return refused(writable.error());
    const SampledModel result =
        sampledModel(**model, *values, *shape, interpolationNamed(options.grid.interpolation), isCsv ? 9 : 3);
    if (const auto saved = saveTable(options.out, *format, result.table); !saved)
        return refused(saved.error());
    const auto& all = result.table.values;
    if (std::none_of(all.begin(), all.end(), [](double v) { return v != 0.0 && !std::isnan(v); }))
        std::cerr << "reflectance: every sample of " << (*model)->id() << " is 0: what it reflects meets no grid\n";
    if (result.isUnderWhite)
        std::cerr << "reflectance: the format holds no matrix: " << options.out
                  << " holds the colour under white light, the sums of K's rows; a .csv holds all nine numbers\n";
    return reported(options.out, options.json, result.table, &result.error);
}

/// The measurement's own grid, where the format holds it and no other was asked for.
const Table* ownGrid(const Measurement& measurement, TableFormat format, const GridOptions& options)
{
    const auto* const table = std::get_if<Table>(&measurement);
    return table && options.grid.empty() && checkHolds(format, *table) ? table : nullptr;
}

int runConvert(const ConvertOptions& options)
{
    const auto format = tableFormatOf(options.out);
    if (!format)
        return refused(format.error());
    const auto shape = shapeFor(options.grid, naturalShape(*format));
    if (!shape)
        return refused(shape.error());
    const auto measurement = measurementFrom(options.source);
    if (!measurement)
        return refused(measurement.error());
    if (const Table* const own = ownGrid(*measurement, *format, options.grid)) {
        const auto saved = saveTable(options.out, *format, *own);
        return saved ? reported(options.out, options.json, *own, nullptr) : refused(saved.error());
    }
    const BrdfFunction f = functionOf(*measurement);
    Table table = sampled(*shape, channelsOf(*measurement), f);
    table.interpolation = interpolationNamed(options.grid.interpolation);
    table.provenance = provenanceOf(*measurement);
    const ResamplingError error = resamplingError(f, table);
    const auto saved = saveTable(options.out, *format, table);
    return saved ? reported(options.out, options.json, table, &error) : refused(saved.error());
}

void addSample(CLI::App& table, int& exitCode)
{
    auto options = std::make_shared<SampleOptions>();
    CLI::App* verb = table.add_subcommand("sample", "Sample a model into a table");
    addModelChoice(*verb, options->model, "reflectance model");
    verb->add_option("--set", options->assignments, "name=value of a parameter; may be repeated");
    verb->add_option("--out", options->out, ".csv, .binary (MERL), .json or .xompt (OpenMATERIAL 3D)")->required();
    verb->add_option("--json", options->json, "what was written, to a file or - for standard output");
    addGridOptions(*verb, options->grid);
    verb->callback([options, &exitCode] { exitCode = runSample(*options); });
}

void addConvert(CLI::App& table, int& exitCode)
{
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* verb = table.add_subcommand("convert", "Write a measured table in another format, or on another grid");
    addSourceOptions(*verb, options->source);
    verb->add_option("out", options->out, ".csv, .binary (MERL), .json or .xompt (OpenMATERIAL 3D)")->required();
    verb->add_option("--json", options->json, "what was written, to a file or - for standard output");
    addGridOptions(*verb, options->grid);
    verb->callback([options, &exitCode] { exitCode = runConvert(*options); });
}

void addInfo(CLI::App& table, int& exitCode)
{
    auto options = std::make_shared<InfoOptions>();
    CLI::App* verb = table.add_subcommand("info", "What a measured table holds, and what its numbers are worth");
    addSourceOptions(*verb, options->source);
    verb->add_option("--json", options->json, "all figures as JSON, to a file or - for standard output");
    verb->add_option("--reciprocity", options->map, "CSV for the map of f(i, r) - f(r, i) over theta_i and theta_r");
    verb->add_option("--azimuth", options->azimuth, "degrees: delta_phi of that map; 180 holds the mirror direction")
        ->capture_default_str();
    verb->callback([options, &exitCode] { exitCode = runInfo(*options); });
}

} // namespace

void addTable(CLI::App& program, int& exitCode)
{
    CLI::App* verb = program.add_subcommand("table", "Measured tables: info, sample, convert");
    verb->require_subcommand(1);
    addInfo(*verb, exitCode);
    addSample(*verb, exitCode);
    addConvert(*verb, exitCode);
}

} // namespace reflectance::cli
