// `surfaces`: the library of surface constants, searched, with what each surface does to the light.
#include "app/cli/report.h"
#include "app/cli/verbs.h"
#include "core/base/text.h"
#include "core/study/properties/light_budget.h"
#include "core/surfaces/library.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using properties::BudgetMeter;
using properties::LightBudget;

struct Options {
    std::string search;
    std::string group;
    std::string json;
};

const Model& modelOf(const LibrarySurface& surface)
{
    return **findModel(surface.group->model);
}

LightBudget budgetOf(const LibrarySurface& surface, BudgetMeter& meter)
{
    return meter.budgetOf(modelOf(surface), flatValues(modelOf(surface).text, surface.values));
}

void printGroup(const SurfaceGroup& group)
{
    std::cout << (group.id + "  -  " + group.name + "\n    model: " + group.model + "\n    source: " + group.source +
                  "\n    convention: " + group.convention + "\n    note: " + group.note + "\n\n");
}

void printSurface(const LibrarySurface& surface, const LightBudget& budget)
{
    std::vector<std::string> pieces;
    for (const auto& [name, numbers] : surface.values)
        pieces.push_back(name + "=" + inBrief(numbers));
    for (const SurfaceFact& fact : surface.facts)
        pieces.push_back(fact.name + ": " + fact.text);
    std::cout << "    " << surface.id << "\n        " << joined(pieces, "  ") << "\n        "
              << properties::budgetText(budget) << (budget.passive() ? "" : ": more than arrives") << '\n';
}

nlohmann::ordered_json described(const LibrarySurface& surface, const LightBudget& budget)
{
    const auto finite = [](double value) {
        return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
    };
    nlohmann::ordered_json facts = nlohmann::ordered_json::object();
    for (const SurfaceFact& fact : surface.facts)
        facts[fact.name] = fact.text;
    return {{"id", surface.id},
            {"name", surface.name},
            {"group", surface.group->id},
            {"model", surface.group->model},
            {"parameters", surface.values},
            {"facts", facts},
            {"largest_albedo", finite(budget.largest)},
            {"largest_albedo_at_degrees", budget.angle},
            {"passive", budget.passive()}};
}

nlohmann::ordered_json described(const SurfaceGroup& group)
{
    return {{"id", group.id},
            {"name", group.name},
            {"model", group.model},
            {"source", group.source},
            {"convention", group.convention},
            {"note", group.note}};
}

Result<void> checkGroup(const std::string& id)
{
    std::vector<std::string> ids;
    for (const auto& group : surfaceGroups())
        ids.push_back(group->id);
    if (id.empty() || std::find(ids.begin(), ids.end(), id) != ids.end())
        return {};
    return Error{"--group: unknown group '" + id + "'; did you mean '" + nearestName(id, ids) +
                 "'? Groups: " + joined(ids)};
}

int run(const Options& options)
{
    if (const auto known = checkGroup(options.group); !known)
        return refused(known.error());
    const auto found = searchSurfaces(options.search, options.group);
    BudgetMeter meter;
    nlohmann::ordered_json groups = nlohmann::ordered_json::array();
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const SurfaceGroup* group = nullptr;
    for (const LibrarySurface* surface : found) {
        const LightBudget budget = budgetOf(*surface, meter);
        if (surface->group.get() != group) {
            group = surface->group.get();
            groups.push_back(described(*group));
            if (options.json.empty())
                printGroup(*group);
        }
        if (options.json.empty())
            printSurface(*surface, budget);
        list.push_back(described(*surface, budget));
    }
    if (options.json.empty())
        std::cout << (found.empty() ? "" : "\n") << found.size() << (found.size() == 1 ? " surface\n" : " surfaces\n");
    const auto written = writeReport(options.json, {{"groups", groups}, {"surfaces", list}});
    return written ? Done : refused(written.error());
}

} // namespace

void addSurfaces(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand(
        "surfaces",
        "The library of surface constants: parameters, source, convention, and how much light each returns; "
        "'render --surface ID' shows one");
    verb->add_option("--search", options->search, "words that must occur in name, group, model, source or note");
    verb->add_option("--group", options->group, "one group, by its id");
    verb->add_option("--json", options->json, "as JSON, to a file or - for standard output");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
