// `export`: a model with its parameters as code or as a table that checks itself.
#include "app/cli/report.h"
#include "app/cli/scene_options.h"
#include "app/cli/verbs.h"
#include "core/base/file.h"
#include "core/study/exports/export_model.h"
#include "core/study/exports/test_vectors.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct ExportOptions {
    SceneOptions surface;
    std::string form;
    std::string out;
    std::string json;
};

Result<ExportForm> formFrom(const ExportOptions& options)
{
    for (const ExportFormFacts& facts : exportForms())
        if (facts.name == options.form)
            return facts.form;
    if (const auto form = formForFile(options.out))
        return *form;
    if (options.out.empty())
        return Error{"nothing says which form; add --as glsl, cpp or csv"};
    return Error{"the ending of '" + options.out + "' tells no form; add --as glsl, cpp or csv"};
}

Result<Surface> surfaceFrom(const SceneOptions& options)
{
    if (options.model.empty() && options.modelFile.empty() && options.surface.empty())
        return Error{"nothing says which model; add --model ID, --surface ID or --model-file FILE"};
    Surface surface;
    if (const auto set = setSurface(options, surface); !set)
        return set.error();
    return surface;
}

int run(const ExportOptions& options)
{
    const auto form = formFrom(options);
    if (!form)
        return refused(form.error());
    const auto surface = surfaceFrom(options.surface);
    if (!surface)
        return refused(surface.error());
    const Model& model = modelOf(*surface);
    const ExportSubject subject{&model, flatValues(model.text, surface->values), lookUpsIn(surface->table.get()),
                                surface->tableFile};
    const auto text = exported(subject, *form);
    if (!text)
        return refused(text.error());
    const bool toOutput = options.out.empty() || options.out == "-";
    if (toOutput)
        std::cout << *text << std::flush;
    else if (const auto written = writeAtomically(options.out, *text); !written)
        return refused(written.error());
    const auto vectors = testVectors(model, subject.values, subject.measured);
    const auto reported = writeReport(options.json, {{"model", model.id()},
                                                     {"form", exportForms()[static_cast<std::size_t>(*form)].name},
                                                     {"file", toOutput ? "-" : options.out},
                                                     {"bytes", text->size()},
                                                     {"test_vectors", vectors.size()}});
    return reported ? Done : refused(reported.error());
}

} // namespace

void addExport(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<ExportOptions>();
    CLI::App* verb = program.add_subcommand(
        "export", "A model with its parameters as a GLSL function, a C++ header or a table; each carries test vectors "
                  "with what double gives and a tolerance, and the code checks itself by them");
    addSurfaceOptions(*verb, options->surface);
    verb->add_option("--as", options->form, "glsl, cpp or csv; default: what the ending of the file says")
        ->check(CLI::IsMember({"glsl", "cpp", "csv"}));
    verb->add_option("-o,--out", options->out, "file to write; default: standard output");
    verb->add_option("--json", options->json, "what was written, to a file or - for standard output");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
