// The program: verbs for scripts, and without a verb the explorer.
#include "app/cli/command_pages.h"
#include "app/cli/render_options.h"
#include "app/cli/verbs.h"
#include "app/explorer/explorer.h"
#include "app/explorer/tour.h"
#include "core/render/pictures/render_picture.h"
#include "core/sensor/picture.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>
#include <optional>

namespace reflectance::cli {
namespace {

constexpr const char* description =
    "Understand, compare and trust reflectance models: illumination -> surface reflectance -> sensor.\n"
    "Without a verb the explorer opens, on the mesh or scene named, else on a clay mug.";

Notes notesFor(const Scene& scene, const Rendered& rendered)
{
    return keptNotes(scene, recipeFrom(RenderOptions(), RenderSettings(), rendered.backend, rendered.precision), {});
}

/// Without a display the default view goes to a picture, and the user learns how to get others.
int renderInstead(const explorer::ExplorerOptions& wanted)
{
    constexpr const char* out = "reflectance.png";
    SceneOptions options;
    options.input = wanted.input;
    options.modelFile = wanted.modelFile;
    options.environment = wanted.environment.value_or("");
    const auto scene = sceneFrom(options);
    if (!scene)
        return refused(scene.error());
    const auto rendered = renderPicture(*scene, RenderSettings(), RenderPlan());
    if (!rendered)
        return refused(rendered.error());
    const auto saved = savePicture(out, rendered->image, scene->sensor, notesFor(*scene, *rendered));
    if (!saved)
        return refused(saved.error());
    std::cerr << "reflectance: there is no display to open a window on, so the view was rendered to " << out
              << "; 'reflectance render --help' tells how to render others\n";
    return Done;
}

int explore(const explorer::ExplorerOptions& options)
{
    const auto ended = explorer::runExplorer(options);
    if (!ended)
        return refused(ended.error());
    return *ended == explorer::Outcome::NoDisplay ? renderInstead(options) : Done;
}

/// The command line as it was typed.
std::string typed(int argc, char** argv)
{
    std::string text = "reflectance";
    for (int i = 1; i < argc; ++i)
        text += std::string(" ") + argv[i];
    return text;
}

int run(int argc, char** argv)
{
    CLI::App program(description, "reflectance");
    program.set_version_flag("--version", std::string("reflectance ") + REFLECTANCE_VERSION);
    explorer::ExplorerOptions options;
    program.add_option("input", options.input,
                       "mesh (OBJ, PLY, OFF, STL), stock mesh name, scene file (.json) or saved picture (.png, .exr)");
    program.add_option("--model-file", options.modelFile, "a model of your own (.glsl) on the object");
    program.add_option("--environment", options.environment,
                       "latitude-longitude picture (.exr, .hdr) around the object");
    program.add_option("--tour", options.tour, "begin with this step of the guided tour")
        ->check(CLI::Range(1, explorer::tourLength()));
    program.add_option("--record", options.record, "write what you do in the window to this file (JSON), for --replay");
    program.add_option("--replay", options.replay, "do again what a recording holds");
    program.add_flag("--first-picture", options.firstPicture,
                     "open the window, say what its first picture took, stage by stage, and close it");
    bool man = false, completion = false;
    program.add_flag("--man", man, "print the manual page, made from these tables of options");
    program.add_flag("--bash-completion", completion, "print what bash completes, made from the same tables");
    int exitCode = Done;
    addRender(program, exitCode);
    addEval(program, exitCode);
    addModels(program, exitCode);
    addSurfaces(program, exitCode);
    addInspect(program, exitCode);
    addCompare(program, exitCode);
    addExtremes(program, exitCode);
    addCheck(program, exitCode);
    addMatrix(program, exitCode);
    addTable(program, exitCode);
    addFit(program, exitCode);
    addSweep(program, exitCode);
    addBench(program, exitCode);
    addTrade(program, typed(argc, argv), exitCode);
    addGoniometer(program, exitCode);
    addExport(program, exitCode);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return program.exit(help);
    } catch (const CLI::ParseError& error) {
        return refused(
            Error{std::string(error.what()) + "; 'reflectance --help' and 'reflectance VERB --help' tell more"});
    }
    if (man || completion) {
        std::cout << (man ? manPage(program, REFLECTANCE_VERSION) : bashCompletion(program));
        return Done;
    }
    return program.get_subcommands().empty() ? explore(options) : exitCode;
}

} // namespace
} // namespace reflectance::cli

int main(int argc, char** argv)
{
    try {
        return reflectance::cli::run(argc, argv);
    } catch (const std::bad_alloc&) {
        return reflectance::cli::refused({"out of memory; try a smaller mesh, picture or number of samples"});
    } catch (const std::exception& error) {
        return reflectance::cli::refused({error.what()});
    }
}
