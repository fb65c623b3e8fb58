// `render`: one picture, by the GL or the CPU renderer, and the figures about it.
#include "app/cli/chosen_variants.h"
#include "app/cli/highlight.h"
#include "app/cli/lens_picture.h"
#include "app/cli/long_work.h"
#include "app/cli/probe_report.h"
#include "app/cli/render_options.h"
#include "app/cli/report.h"
#include "app/cli/rung_pictures.h"
#include "app/cli/verbs.h"
#include "app/cli/waterfall_report.h"
#include "app/explorer/shown_picture.h"
#include "app/explorer/user_folders.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/image/compare.h"
#include "core/image/picture_file.h"
#include "core/reflectance/kernel_tables.h"
#include "core/render/headless/driver_ahead.h"
#include "core/render/pictures/backend_choice.h"
#include "core/render/pictures/picture_waterfall.h"
#include "core/scene/only_term.h"
#include "core/scene/requirements.h"
#include "core/scene/scene_file.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Options = RenderOptions;

/// Of the surfaces that are shown.
nlohmann::ordered_json rungsReport(const Scene& scene, VariantView shown, const std::vector<SkippedRung>& withoutEffect)
{
    nlohmann::ordered_json rungs;
    if (shown != VariantView::B)
        rungs["A"] = scene.surface.rungs;
    if (shown != VariantView::A && scene.other)
        rungs["B"] = scene.other->rungs;
    for (const SkippedRung& rung : withoutEffect)
        rungs["without_effect"].push_back({{"rung", rung.rung}, {"why", rung.why}});
    return rungs;
}

nlohmann::ordered_json differenceReport(const explorer::DifferenceFigures& figures)
{
    return {
        {"identical", figures.identical}, {"rmse", figures.rmse}, {"max", figures.maxAbs}, {"pixels", figures.pixels}};
}

nlohmann::ordered_json report(const Options& options, const Scene& scene, const PictureRecipe& recipe,
                              const Rendered& rendered, const SensorCounts& counts,
                              const std::optional<Waterfall>& waterfall, std::optional<std::size_t> highlight)
{
    nlohmann::ordered_json figures{{"out", options.out},
                                   {"variant", nameOf(recipe.shown)},
                                   {"width", recipe.width},
                                   {"height", recipe.height},
                                   {"samples", recipe.samplesPerAxis * recipe.samplesPerAxis},
                                   {"model", scene.surface.model},
                                   {"triangles", scene.mesh->triangles.size()},
                                   {"backend", rendered.backend},
                                   {"precision", rendered.precision},
                                   {"lobe", recipe.lobe},
                                   {"first_frame_ms", rendered.firstFrameMilliseconds},
                                   {"shading_ms", rendered.shadingMilliseconds},
                                   {"negative_pixels", counts.negative},
                                   {"clipped_pixels", counts.clipped},
                                   {"non_finite_pixels", counts.nonFinite},
                                   {"left_out", options.general ? std::vector<std::string>() : leftOut(scene)}};
    if (rendered.generalMilliseconds > 0.0)
        figures["general_shading_ms"] = rendered.generalMilliseconds;
    if (rendered.leftOutBytes > 0)
        figures["left_out_bytes"] = rendered.leftOutBytes;
    if (highlight)
        figures["highlight"] = lightReport(scene.lights[*highlight], *highlight);
    if (waterfall)
        figures["waterfall"] = waterfallReport(*waterfall);
    return figures;
}

/// A form of the lobe asks for a model that has one, and may not be made for its exponent.
Result<void> checkLobe(const Scene& scene, LobeForm lobe)
{
    const ModelText& text = modelOf(scene).text;
    if (lobe == LobeForm::Conditioned)
        return {};
    if (!text.usesLobe)
        return Error{"--lobe is for models with a highlight (R.V)^n, and " + text.id + " has none; leave it out"};
    return checkExponent(lobe, valuesOf(scene)[text.find("n")->offset]);
}

int compareWithReference(const Options& options, const Image& image)
{
    const auto reference = readPicture(options.reference);
    if (!reference)
        return refused(reference.error());
    const auto metrics = compared(image, reference->image);
    if (!metrics)
        return refused(metrics.error());
    const bool holds = metrics->maxAbs <= options.threshold;
    std::cerr << "reference " << options.reference << ": largest difference " << general(metrics->maxAbs, 6)
              << (holds ? " is within " : " is beyond ") << general(options.threshold, 6) << '\n';
    return holds ? Done : DoesNotHold;
}

/// What the reference is held against: the picture as it was written, so that a PNG compares with a PNG.
Result<Image> asWritten(const std::string& path)
{
    auto picture = readPicture(path);
    if (!picture)
        return picture.error();
    return std::move(picture->image);
}

/// The picture that was asked for, and what the last rendering of it took.
struct Made {
    explorer::ShownPicture picture;
    PictureRecipe recipe;
    Rendered last;   ///< without its image
    std::string why; ///< the backend was chosen; empty where it was asked for
    std::vector<SkippedRung> withoutEffect = {};
};

/// A flag that names something of one of them leaves no choice.
bool isFree(const Options& options, const RenderPlan& plan)
{
    const bool onMesh = plan.place == Place::Vertex || plan.place == Place::Face;
    return plan.backend == Backend::Auto && !onMesh && !options.noCache && options.context == "any";
}

bool mayNeedDriver(const Options& options, const RenderPlan& plan)
{
    if (!isFree(options, plan))
        return plan.backend != Backend::Cpu;
    const auto known = readWholeFile(explorer::backendsFile().string(), mostBackendBytes);
    return !known || !isAlwaysTheCpu(*known);
}

/// `auto`, resolved once for all renderings of a picture.
BackendChoice choiceFor(const Options& options, const Scene& scene, const RenderSettings& settings,
                        const RenderPlan& plan)
{
    if (!isFree(options, plan))
        return {plan.backend, ""};
    return soonerBackend(scene, settings, plan, explorer::backendsFile(), &LongWork::progress());
}

Result<Made> make(const Options& options, const Scene& scene, const RenderSettings& settings, const RenderPlan& plan)
{
    const LongWork work;
    const BackendChoice choice = choiceFor(options, scene, settings, plan);
    RenderPlan chosen = plan;
    chosen.backend = choice.backend;
    Made made;
    made.recipe = recipeFrom(options, settings, "cpu", "double");
    made.why = choice.why;
    std::optional<RungPictures> byRungs;
    if (asksForRungs(scene, made.recipe.shown))
        byRungs.emplace(scene, made.recipe.shown, chosen);
    const auto render = [&](const Scene& variant, int width, int height) -> Result<Image> {
        const RenderSettings size{width, height, settings.samplesPerAxis};
        auto rendered =
            byRungs ? byRungs->render(variant, size) : renderPicture(variant, size, chosen, &LongWork::progress());
        if (!rendered)
            return rendered.error();
        made.last = *std::move(rendered);
        return std::exchange(made.last.image, {});
    };
    auto picture = explorer::shownPicture(scene, made.recipe, render);
    if (!picture)
        return picture.error();
    made.picture = *std::move(picture);
    if (byRungs)
        made.withoutEffect = byRungs->withoutEffect();
    // Rungs are the scene's; the recipe says how the rest is drawn.
    made.recipe = recipeFrom(options, settings, byRungs ? byRungs->backend() : made.last.backend,
                             byRungs ? byRungs->precision() : made.last.precision);
    return made;
}

/// The lens looks at one arithmetic by itself; flags that choose another contradict it.
Result<void> checkLens(const Options& options)
{
    if (!options.out.ends_with(".png"))
        return Error{"--lens paints a PNG; name the output .png"};
    const std::pair<const char*, bool> others[] = {
        {"--precision", !options.precision.empty()},
        {"--backend", options.backend != "auto"},
        {"--shading", !options.shading.empty() && options.shading != "pixel"},
        {"--lobe", !options.lobe.empty() && options.lobe != "conditioned"},
        {"--frames", options.frames != 1},
        {"--term", !options.term.empty() && options.term != "all"},
        {"--variant", !options.variant.empty() && options.variant != "A"},
        {"--reference", !options.reference.empty()},
        {"--waterfall", options.waterfall}};
    for (const auto& [flag, given] : others)
        if (given)
            return Error{std::string("--lens compares one arithmetic with double; leave ") + flag + " out"};
    return {};
}

int runLens(const Options& options, const Scene& scene, const RenderSettings& settings)
{
    const LensKind kind = lensNamed(options.lens);
    const auto map = lensOf(scene, settings, kind, contextNamed(options.context));
    if (!map)
        return refused(map.error(), LongWork::wasStopped() ? Stopped : BadInput);
    const Notes notes = explorer::notesFor(options.out, scene, recipeFrom(options, settings, "cpu", "float"));
    if (const auto written = writeLens(options.out, *map, notes); !written)
        return refused(written.error());
    const auto reported = writeReport(options.json, lensReport(kind, *map));
    return reported ? Done : refused(reported.error());
}

/// What the picture is made of: the scene, or what of it is to be seen alone.
Result<Scene> viewedScene(const Options& options, const Scene& scene)
{
    if (options.term.empty() || options.term == "all")
        return scene;
    if (options.waterfall)
        return Error{"--waterfall follows the whole picture; leave --term out"};
    auto alone = onlyTerm(scene, options.term);
    return alone ? alone : Error{"--term " + options.term + ": " + alone.error().message};
}

/// From the truth to what was written, where it was asked for.
Result<std::optional<Waterfall>> waterfallFrom(const Options& options, const Scene& scene,
                                               const RenderSettings& settings, const Made& made)
{
    if (!options.waterfall)
        return std::optional<Waterfall>();
    if (made.recipe.shown != VariantView::A)
        return Error{"--waterfall follows one surface, A; leave --variant out"};
    auto truth = options.truth.empty() ? Result<Scene>(scene) : loadScene(options.truth);
    if (!truth)
        return truth.error();
    const LongWork work;
    auto waterfall = waterfallOf(picturesToTruth(scene, *truth, settings, made.picture.linear, &LongWork::progress()));
    if (LongWork::wasStopped())
        return Error{"stopped before the waterfall was measured"};
    if (!waterfall)
        return waterfall.error();
    printWaterfall(*waterfall);
    return std::optional(*std::move(waterfall));
}

/// What a reader of the picture would not see in it.
void tellRungs(const Made& made)
{
    for (const SkippedRung& rung : made.withoutEffect)
        std::cerr << "rung " << rung.rung << " changes nothing: " << rung.why << '\n';
    if (const auto& difference = made.picture.difference)
        std::cerr << explorer::figuresText(difference) << '\n';
}

int renderAndReport(const Options& options, const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                    std::optional<std::size_t> highlight)
{
    const auto viewed = viewedScene(options, scene);
    if (!viewed)
        return refused(viewed.error());
    const auto made = make(options, *viewed, settings, plan);
    if (!made)
        return refused(made.error(), LongWork::wasStopped() ? Stopped : BadInput);
    if (const auto saved = saveShown(options.out, made->picture, scene, made->recipe); !saved)
        return refused(saved.error());
    const auto waterfall = waterfallFrom(options, scene, settings, *made);
    if (!waterfall)
        return refused(waterfall.error(), LongWork::wasStopped() ? Stopped : BadInput);
    auto figures = report(options, scene, made->recipe, made->last, made->picture.codes.counts, *waterfall, highlight);
    if (!made->why.empty())
        figures["backend_why"] = made->why;
    if (asksForRungs(scene, made->recipe.shown))
        figures["rungs"] = rungsReport(scene, made->recipe.shown, made->withoutEffect);
    if (made->picture.difference)
        figures["difference"] = differenceReport(*made->picture.difference);
    tellRungs(*made);
    if (const auto written = writeReport(options.json, figures); !written)
        return refused(written.error());
    if (options.reference.empty())
        return Done;
    const auto image = asWritten(options.out);
    return image ? compareWithReference(options, *image) : refused(image.error());
}

/// One point of the picture instead of the picture.
int runProbe(const Options& options)
{
    const auto parts = split(options.probe, ',');
    const auto x = parts.size() == 2 ? parseNumber(trimmed(parts[0])) : std::nullopt;
    const auto y = parts.size() == 2 ? parseNumber(trimmed(parts[1])) : std::nullopt;
    if (!x || !y)
        return refused(
            Error{"--probe " + options.probe + ": write X,Y in pixels from the upper left corner, as in 320,240.5"});
    const auto settings = settingsFrom(options.scene);
    if (!settings)
        return refused(settings.error());
    const auto scene = sceneFrom(options.scene);
    if (!scene)
        return refused(scene.error());
    const auto point = pointAt(*scene->mesh, scene->camera, *x, *y, settings->width, settings->height);
    if (!point)
        return refused(Error{"--probe " + options.probe + ": the object is not seen there; the picture is " +
                             std::to_string(settings->width) + "x" + std::to_string(settings->height)});
    const auto viewed = viewedScene(options, *scene);
    if (!viewed)
        return refused(viewed.error());
    const Probe probe = probeAt(*viewed, *point);
    if (options.json != "-")
        std::cout << probeText(probe) << std::flush;
    const auto written = writeReport(options.json, probeReport(probe));
    return written ? Done : refused(written.error());
}

int run(const Options& asked)
{
    if (!asked.probe.empty())
        return runProbe(asked);
    if (asked.out.empty())
        return refused(Error{"--out is missing; name a picture (.png, .exr or .pfm), or a point by --probe X,Y"});
    const auto format = outputFormat(asked.out);
    if (!format)
        return refused(format.error());
    for (const std::string& file : {asked.out, asked.json})
        if (const auto writable = checkWritable(file); !writable && !file.empty() && file != "-")
            return refused(writable.error());
    const auto recipe = recipeOf(asked.scene);
    if (!recipe)
        return refused(recipe.error());
    Options options = *recipe ? completed(asked, **recipe) : asked;
    const auto plan = planFrom(options);
    if (!plan)
        return refused(plan.error());
    if (const auto clear = checkLens(options); !options.lens.empty() && !clear)
        return refused(clear.error());
    const auto settings = settingsFrom(options.scene);
    if (!settings)
        return refused(settings.error());
    const std::jthread driver = mayNeedDriver(options, *plan) ? openDriverAhead(plan->context) : std::jthread();
    auto scene = sceneFrom(options.scene);
    if (!scene)
        return refused(scene.error());
    if (const auto chosen = chooseVariants(options, *scene); !chosen)
        return refused(chosen.error());
    std::optional<std::size_t> highlight;
    if (!options.highlightAt.empty()) {
        const auto moved = putHighlight(options.highlightAt, *settings, *scene);
        if (!moved)
            return refused(moved.error());
        highlight = *moved;
    }
    if (!options.edgeAt.empty()) {
        const auto width = putEdge(options.edgeAt, *settings, *scene);
        if (!width)
            return refused(width.error());
        std::cerr << width->first << " = " << general(width->second, 6) << '\n';
    }
    if (const auto fits = checkLobe(*scene, plan->lobe); !fits)
        return refused(fits.error());
    return options.lens.empty() ? renderAndReport(options, *scene, *settings, *plan, highlight)
                                : runLens(options, *scene, *settings);
}

/// Which of two surfaces is shown, and how.
void addVariantOptions(CLI::App& verb, Options& options)
{
    verb.add_option(
        "--variant", options.variant,
        "of a scene with two surfaces: A (the default), B, both side by side or in a wipe, or the signed "
        "difference of luminance, B less A (PNG); or the name of a variant that the scene keeps, drawn with "
        "the rungs that it keeps (see trade --list)");
    verb.add_option("--a", options.variantA, "NAME of a kept variant, in A's place");
    verb.add_option("--b", options.variantB, "NAME of a kept variant, in B's place");
    verb.add_option("--divider", options.divider, "of a wipe: A's share of the width")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
}

/// Points in the picture: what happens there, and what shall.
void addPoints(CLI::App& verb, Options& options)
{
    verb.add_option("--probe", options.probe,
                    "X,Y in pixels: no picture, but what happens at this point, from the lights to the code value");
    verb.add_option(
            "--highlight-at", options.highlightAt,
            "X,Y[,LIGHT] in pixels: that light (from 1; the first that is on) moves so that its highlight peaks "
            "there, R.V = 1; where the surface has none, N.L = 1")
        ->excludes(verb.get_option("--probe"));
    verb.add_option(
            "--edge-at", options.edgeAt,
            "X,Y[,LIGHT] in pixels: the number of the model that makes its highlight wide or narrow (n, alpha, m) "
            "becomes the one with which that light's highlight has half its height there; after --highlight-at")
        ->excludes(verb.get_option("--probe"));
}

/// By what the picture is computed.
void addWays(CLI::App& verb, Options& options)
{
    verb.add_option(
            "--backend", options.backend,
            "auto (GL on a graphics card; without one what is sooner done, tried once per size of picture), gl or cpu")
        ->check(CLI::IsMember({"auto", "gl", "cpu"}))
        ->capture_default_str();
    verb.add_option("--precision", options.precision, "double, float or simd choose the CPU renderer, glsl the GL one")
        ->check(CLI::IsMember({"double", "float", "simd", "glsl"}));
    verb.add_option("--context", options.context, "GL context: any, osmesa or egl")
        ->check(CLI::IsMember({"any", "osmesa", "egl"}))
        ->capture_default_str();
    verb.add_option("--shading", options.shading,
                    "where the model is evaluated: pixel (at every sample, the default), fragment (once per "
                    "triangle in a pixel, as multisampling does), once (per pixel), vertex "
                    "(interpolated over triangles; CPU) or face (CPU)")
        ->check(CLI::IsMember({"pixel", "fragment", "once", "vertex", "face"}));
    verb.add_option("--lobe", options.lobe,
                    "how a highlight's (R.V)^n is computed: conditioned (right, the default), power, squarings (whole "
                    "n), truncated, schlick or table");
    verb.add_flag("--no-cache", options.noCache,
                  "neither use nor keep linked shaders and measured backends; auto is then GL where there is one");
    verb.add_flag("--no-specialise", options.general,
                  "run the general shader or kernel: terms that are 0 are computed too, for comparison");
    verb.add_option("--frames", options.frames, "shade this often and report the median time")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
}

/// What of it is seen.
void addParts(CLI::App& verb, Options& options)
{
    verb.add_option("--lens", options.lens,
                    "paint the digits that float, half, simd or glsl keep of double, instead of the view (PNG)")
        ->check(CLI::IsMember({"float", "half", "simd", "glsl"}));
    addVariantOptions(verb, options);
    verb.add_option(
        "--term", options.term,
        "what of the picture is seen alone: diffuse, specular or another term of the formula, offdiagonal (of "
        "K), light:N, or all; the scene that the picture carries stays whole");
}

/// What else is told of it.
void addFigures(CLI::App& verb, Options& options)
{
    verb.add_option("--reference", options.reference, "picture to compare with: exit 0 if within --threshold, else 1");
    verb.add_option("--threshold", options.threshold, "largest linear difference that still holds")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    CLI::Option* waterfall = verb.add_flag(
        "--waterfall", options.waterfall,
        "how much of the difference from the truth comes from geometry, model, precision, sensor and encoding");
    verb.add_option("--truth", options.truth,
                    "scene file whose mesh and surface are the truth of --waterfall (default: the scene's own)")
        ->needs(waterfall);
    verb.add_option("--json", options.json, "figures about the picture, to a file or - for standard output");
}

} // namespace

void addRender(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand("render", "One picture of a mesh or a scene, without a window");
    addSceneOptions(*verb, options->scene);
    verb->add_option("--out", options->out,
                     "picture to write: .png (after the sensor), .exr or .pfm (linear, before it)");
    addPoints(*verb, *options);
    addWays(*verb, *options);
    addParts(*verb, *options);
    addFigures(*verb, *options);
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
