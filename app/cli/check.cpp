// `check`: holds every model to what physics asks and what its text declares.
#include "app/cli/check_report.h"
#include "app/cli/report.h"
#include "app/cli/verbs.h"
#include "core/base/text.h"
#include "core/reflectance/own_model.h"
#include "core/study/properties/matrix_facts.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string model;
    std::string modelFile;
    std::string json;
    bool thorough = false;
};

std::string padded(std::string text, std::size_t width)
{
    text.resize(std::max(text.size() + 1, width), ' ');
    return text;
}

void print(const ModelText& model, const properties::PropertyResult& result)
{
    std::cout << "    " << padded(std::string(result.property.name), 15)
              << padded(std::string(nameOf(result.verdict)), 18) << padded(general(result.finding.worst, 6), 14)
              << padded(general(result.property.allowed, 7), 10) << result.property.asks << '\n';
    if (!result.finding.note.empty())
        std::cout << "                   " << result.finding.note << '\n';
    if (result.verdict == properties::Verdict::Holds)
        return;
    if (!result.finding.at.values.empty())
        std::cout << "                   worst at " << placeText(model, result.finding.at) << '\n';
    if (result.verdict != properties::Verdict::Reported && !result.declared.empty())
        std::cout << "                   declared \"" << result.declared << "\"\n";
}

std::string complexText(const std::complex<double>& z)
{
    // An imaginary part that rounding alone brought is not shown.
    if (std::fabs(z.imag()) < 1e-7)
        return general(z.real(), 4);
    return general(z.real(), 4) + (z.imag() < 0.0 ? "-" : "+") + general(std::fabs(z.imag()), 4) + "i";
}

void print(const Parameter& matrix)
{
    const properties::MatrixFacts facts = properties::matrixFacts(matrix.initial);
    std::vector<std::string> sums;
    std::vector<std::string> eigenvalues;
    for (std::size_t i = 0; i < 3; ++i) {
        sums.push_back(general(facts.rowSums[i], 4));
        eigenvalues.push_back(complexText(facts.eigenvalues[i]));
    }
    std::cout << "    default " << matrix.name << ": row sums " << joined(sums, " ") << "; eigenvalues "
              << joined(eigenvalues, " ") << "; spectral radius " << general(facts.spectralRadius, 4)
              << "; negative entries " << facts.negativeEntries << "; " << (facts.passive ? "passive" : "not passive")
              << '\n';
}

/// Checks one model, prints it unless JSON goes to standard output, and counts verdicts.
Json checked(const Model& model, const Options& options, std::map<properties::Verdict, int>& counts)
{
    const auto results =
        properties::checkModel(model, options.thorough ? properties::thoroughEffort() : properties::Effort());
    const bool quiet = options.json == "-";
    if (!quiet)
        std::cout << model.id() << "  -  " << model.text.name << '\n';
    Json rows = Json::array();
    for (const properties::PropertyResult& result : results) {
        ++counts[result.verdict];
        rows.push_back(described(model.text, result));
        if (!quiet)
            print(model.text, result);
    }
    Json matrices = Json::array();
    for (const Parameter& parameter : model.text.parameters)
        if (parameter.kind == ParameterKind::Matrix) {
            matrices.push_back(matrixReport(parameter));
            if (!quiet)
                print(parameter);
        }
    if (!quiet)
        std::cout << std::endl; // a model at a time, while the next is under way
    return {{"model", model.id()},
            {"as_declared", properties::asDeclared(results)},
            {"properties", rows},
            {"matrices", matrices}};
}

/// What is to be checked: the own model alone, or those of the catalogue.
Result<std::vector<const Model*>> wanted(const Options& options, std::shared_ptr<const Model>& own)
{
    if (!options.modelFile.empty()) {
        auto read = readOwnModel(options.modelFile);
        if (!read)
            return read.error();
        own = *std::move(read);
        return std::vector<const Model*>{own.get()};
    }
    std::vector<const Model*> models;
    // A table is as good as its measurement; `table info` says how good that is.
    for (const Model& model : catalogue())
        if (!model.text.usesTable && (options.model.empty() || model.id() == options.model))
            models.push_back(&model);
    return models;
}

int run(const Options& options)
{
    if (!options.model.empty())
        if (const auto found = findModel(options.model); !found)
            return refused(found.error());
    std::shared_ptr<const Model> own;
    const auto asked = wanted(options, own);
    if (!asked)
        return refused(asked.error());
    if (options.json != "-")
        std::cout << "    property       verdict           worst         allowed   what it asks\n\n";
    std::map<properties::Verdict, int> counts;
    Json models = Json::array();
    for (const Model* model : *asked)
        models.push_back(checked(*model, options, counts));
    const int broken = counts[properties::Verdict::Broken];
    if (options.json != "-")
        std::cout << models.size() << (models.size() == 1 ? " model: " : " models: ")
                  << counts[properties::Verdict::Holds] << " properties hold, "
                  << counts[properties::Verdict::ExpectedFailure] << " fail as declared, "
                  << counts[properties::Verdict::Reported] << " reported, " << broken << " BROKEN\n";
    const auto written = writeReport(options.json, {{"as_declared", broken == 0}, {"models", models}});
    if (!written)
        return refused(written.error());
    return broken == 0 ? Done : DoesNotHold;
}

} // namespace

void addCheck(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand(
        "check", "Furnace, reciprocity, passivity and limits of every model over its parameter ranges");
    verb->add_option("--model", options->model, "this model only");
    verb->add_option("--model-file", options->modelFile, "a model of your own, and no other");
    verb->add_option("--json", options->json, "all figures as JSON, to a file or - for standard output");
    verb->add_flag("--thorough", options->thorough, "more parameters and directions: a minute instead of a second");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
