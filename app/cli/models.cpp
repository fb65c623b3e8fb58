// `models`: the catalogue, as text, JSON or the page docs/models.md.
#include "app/cli/report.h"
#include "app/cli/verbs.h"
#include "core/base/text.h"
#include "core/reflectance/catalogue.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct Options {
    bool markdown = false;
    std::string json;
};

constexpr const char* measurements = "CSV, OpenMATERIAL 3D, MERL, RGL, Cornell, CUReT or Zemax";

/// "colour", "choice: 2 or 8", "list of 5 or 55"
std::string kindName(const Parameter& p)
{
    std::vector<std::string> counts;
    for (const double choice : p.choices)
        counts.push_back(shortest(choice));
    for (const ListForm& form : p.forms)
        counts.push_back(std::to_string(form.names.size()));
    constexpr const char* names[] = {"number", "colour", "3x3 matrix", "choice: ", "list of "}; // as ParameterKind
    return names[static_cast<std::size_t>(p.kind)] + joined(counts, " or ");
}

std::string numbersText(const std::vector<double>& numbers)
{
    std::vector<std::string> texts;
    for (const double number : numbers)
        texts.push_back(shortest(number));
    return joined(texts, " ");
}

std::string rangeText(double low, double high)
{
    if (std::isinf(low) && std::isinf(high))
        return "any finite number";
    if (std::isinf(high))
        return ">= " + shortest(low);
    return shortest(low) + " .. " + shortest(high);
}

/// JSON has no infinity: an open end is null.
nlohmann::ordered_json bound(double value)
{
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json described(const Parameter& p)
{
    return {{"name", p.name},
            {"label", p.label},
            {"kind", kindName(p)},
            {"default", p.initial},
            {"slider", {p.sliderMin, p.sliderMax}},
            {"logarithmic", p.logarithmic},
            {"legal", {bound(p.legalMin), bound(p.legalMax)}},
            {"unit", p.unit.empty() ? "1" : p.unit},
            {"tooltip", p.tooltip},
            {"source", p.source}};
}

nlohmann::ordered_json described(const ModelText& model)
{
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
    for (const Parameter& p : model.parameters)
        parameters.push_back(described(p));
    nlohmann::ordered_json limits = nlohmann::ordered_json::array();
    for (const DeclaredLimit& limit : model.becomes)
        limits.push_back({{"model", limit.model}, {"where", limit.where}});
    return {{"id", model.id},
            {"name", model.name},
            {"family", model.family},
            {"formula", model.formula},
            {"citation", model.citation},
            {"about", model.about},
            {"reciprocal", {{"holds", model.reciprocal.holds}, {"declared", model.reciprocal.reason}}},
            {"passive", {{"holds", model.passive.holds}, {"declared", model.passive.reason}}},
            {"nonnegative", {{"holds", model.nonnegative.holds}, {"declared", model.nonnegative.reason}}},
            {"becomes", limits},
            {"sees_environment", model.usesEnvironment},
            {"sees_light_size", model.usesLightSize},
            {"needs_file", model.usesTable},
            {"parameters", parameters}};
}

/// "HEAD lambert_color where ks=0, phong where K=0"; nothing for a model that becomes no other.
std::string limitsText(const ModelText& model, std::string_view head)
{
    std::vector<std::string> limits;
    for (const DeclaredLimit& limit : model.becomes)
        limits.push_back(limit.model + " where " + limit.where);
    return limits.empty() ? std::string() : std::string(head) + joined(limits);
}

void printText(const ModelText& model)
{
    std::cout << model.id << "  -  " << model.name << "\n    " << model.formula << "\n    " << model.citation
              << "\n    reciprocal: " << model.reciprocal.reason << "\n    passive: " << model.passive.reason
              << (model.nonnegative.holds ? "" : "\n    never negative: " + model.nonnegative.reason)
              << limitsText(model, "\n    becomes: ") << '\n';
    for (const Parameter& p : model.parameters)
        std::cout << "    --set " << p.name << "=...  " << p.label << " (" << kindName(p) << "), "
                  << rangeText(p.legalMin, p.legalMax) << ", default " << numbersText(p.initial) << '\n';
    if (model.usesTable)
        std::cout << "    --set file=PATH  a measurement: " << measurements << '\n';
    std::cout << '\n';
}

void printMarkdown(const ModelText& model)
{
    std::cout << "\n## " << model.name << " (`" << model.id << "`)\n\n    " << model.formula << "\n\n"
              << model.about << "\n\n- Source: " << model.citation << "\n- Reciprocal: " << model.reciprocal.reason
              << "\n- Passive: " << model.passive.reason
              << (model.nonnegative.holds ? "" : "\n- Never negative: " + model.nonnegative.reason)
              << limitsText(model, "\n- Becomes: ")
              << "\n- Sees the environment: " << (model.usesEnvironment ? "yes" : "no")
              << "; sees the size of lights: " << (model.usesLightSize ? "yes" : "no")
              << (model.usesTable ? std::string("\n- Needs a measurement, `file=PATH`: ") + measurements : "");
    if (model.parameters.empty()) {
        std::cout << '\n';
        return;
    }
    std::cout << "\n\n| parameter | meaning | kind | default | slider | legal | unit | source |\n"
                 "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Parameter& p : model.parameters)
        std::cout << "| `" << p.name << "` | " << p.label << ". " << p.tooltip << " | " << kindName(p) << " | "
                  << numbersText(p.initial) << " | " << rangeText(p.sliderMin, p.sliderMax)
                  << (p.logarithmic ? ", logarithmic" : "") << " | " << rangeText(p.legalMin, p.legalMax) << " | "
                  << (p.unit.empty() ? "1" : p.unit) << " | " << p.source << " |\n";
}

int run(const Options& options)
{
    if (options.markdown)
        std::cout
            << "# The reflectance models\n\n"
               "Made by `reflectance models --markdown` from the texts in `shaders/reflectance/`; a test fails when "
               "this page is stale.\nEvery model returns the lecture's factor times the light: cosine included, the "
               "BRDF times pi. R = 2N(N.L) - L.\n";
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Model& model : catalogue()) {
        if (options.markdown)
            printMarkdown(model.text);
        else if (options.json.empty())
            printText(model.text);
        list.push_back(described(model.text));
    }
    const auto written = writeReport(options.json, {{"models", list}});
    return written ? Done : refused(written.error());
}

} // namespace

void addModels(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand(
        "models", "The catalogue: ids, parameters, ranges, defaults, units, citation, declared properties");
    verb->add_flag("--markdown", options->markdown, "as the page docs/models.md");
    verb->add_option("--json", options->json, "as JSON, to a file or - for standard output");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
