// `trade`: what every rung costs and loses on this scene, and the cheapest within a tolerance.
#include "app/cli/long_work.h"
#include "app/cli/report.h"
#include "app/cli/scene_options.h"
#include "app/cli/trade_answers.h"
#include "app/cli/trade_report.h"
#include "app/cli/verbs.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/render/pictures/render_picture.h"
#include "core/study/trade/rung.h"
#include "core/study/trade/trade_chart.h"
#include "core/study/trade/trade_page.h"
#include "core/study/trade/trade_run.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct TradeFlags {
    SceneOptions scene;
    Wanted wanted;
    bool dial = false, terms = false;
    std::string map;
    std::string metric = "max";
    std::string cost = "shading";
    std::string context = "any";
    std::vector<std::string> only;
    int repetitions = 7;
    std::string html, svg, csv, json;
    bool list = false;
};

Metric metricNamed(const std::string& name)
{
    return name == "rmse" ? Metric::Rmse : name == "de" ? Metric::DeltaE : Metric::Max;
}

Result<TradeOptions> optionsFrom(const TradeFlags& flags)
{
    TradeOptions options;
    options.metric = metricNamed(flags.metric);
    options.cost = flags.cost == "frame" ? Cost::FirstFrame : Cost::Shading;
    options.repetitions = flags.repetitions;
    options.only = flags.only;
    for (const std::string& id : flags.only) {
        if (findRung(id))
            continue;
        std::vector<std::string> names;
        for (const Rung& rung : rungs())
            names.emplace_back(rung.id);
        return Error{"--only: there is no rung '" + id + "'; did you mean '" + nearestName(id, names) +
                     "'? --list names them all"};
    }
    return options;
}

int listRungs()
{
    for (const Rung& rung : rungs())
        std::printf("%-20s %-14s %-8s gives up %s\n", rung.id, std::string(nameOf(rung.axis)).c_str(),
                    rung.onCpu && rung.onGl ? "cpu, gl"
                    : rung.onCpu            ? "cpu"
                                            : "gl",
                    rung.about);
    return Done;
}

/// A GL renderer where a context opens, told on stderr where none does.
struct OptionalGl {
    std::unique_ptr<HeadlessContext> context; // outlives the renderer
    std::optional<GlRenderer> renderer;
};

OptionalGl openGl(const std::string& kind)
{
    OptionalGl gl;
    auto context = openHeadless(contextNamed(kind));
    if (!context) {
        std::cerr << "reflectance: GL has no part in this: " << context.error().message << '\n';
        return gl;
    }
    gl.context = *std::move(context);
    if (auto renderer = GlRenderer::create(gl.context->loader()))
        gl.renderer = *std::move(renderer);
    return gl;
}

Result<void> writeFiles(const TradeFlags& flags, const Trade& trade, const std::string& command)
{
    if (!flags.html.empty())
        if (auto written = writeAtomically(flags.html, htmlOf(trade, flags.wanted, command)); !written)
            return written;
    if (!flags.svg.empty())
        if (auto written = writeAtomically(flags.svg, svgOf(chartOf(trade, flags.wanted.tolerance, true), 900, 520));
            !written)
            return written;
    if (!flags.csv.empty())
        if (auto written = writeAtomically(flags.csv, csvOf(trade)); !written)
            return written;
    return writeReport(flags.json, described(trade, flags.wanted));
}

/// The dial's wish, checked; of a whole trade as well, whose tolerance and budget mean the same.
Result<DialWish> wishFrom(const TradeFlags& flags, const TradeOptions& options)
{
    DialWish wish;
    wish.tolerance = flags.wanted.tolerance;
    wish.milliseconds = flags.wanted.milliseconds;
    wish.metric = options.metric;
    wish.cost = options.cost;
    if (!flags.map.empty() && !wish.tolerance)
        return Error{"--map paints where each model is within a tolerance; give --tolerance"};
    if (flags.dial || flags.wanted.anything())
        if (const auto possible = checkWish(wish); !possible)
            return Error{(wish.milliseconds && !wish.tolerance ? "--budget-ms: " : "--tolerance: ") +
                         possible.error().message};
    return wish;
}

int measureAll(const TradeFlags& flags, const Scene& scene, const RenderSettings& settings, const TradeOptions& options,
               GlRenderer* gl, const std::string& command)
{
    const auto trade = [&] {
        const LongWork work;
        return measuredTrade(scene, settings, options, gl, &LongWork::progress());
    }();
    if (!trade)
        return refused(trade.error(), LongWork::wasStopped() ? Stopped : BadInput);
    if (flags.json != "-")
        print(*trade, flags.wanted);
    if (const auto written = writeFiles(flags, *trade, command); !written)
        return refused(written.error());
    return flags.wanted.anything() && !chosen(*trade, flags.wanted) ? DoesNotHold : Done;
}

int runTrade(const TradeFlags& flags, const std::string& command)
{
    if (flags.list)
        return listRungs();
    const auto options = optionsFrom(flags);
    if (!options)
        return refused(options.error());
    const auto wish = wishFrom(flags, *options);
    if (!wish)
        return refused(wish.error());
    for (const std::string& file : {flags.html, flags.svg, flags.csv, flags.json, flags.map})
        if (const auto writable = checkWritable(file); !writable && !file.empty() && file != "-")
            return refused(writable.error());
    const auto settings = settingsFrom(flags.scene, {512, 512, 2});
    if (!settings)
        return refused(settings.error());
    const auto scene = sceneFrom(flags.scene);
    if (!scene)
        return refused(scene.error());
    if (!flags.map.empty())
        return answerMap(*scene, *settings, *wish->tolerance, wish->metric, flags.map, flags.json);
    if (flags.terms)
        return answerTerms(*scene, *settings, flags.repetitions, flags.json);
    OptionalGl gl = openGl(flags.context);
    GlRenderer* renderer = gl.renderer ? &*gl.renderer : nullptr;
    return flags.dial ? answerDial(*scene, *settings, *wish, renderer, flags.json)
                      : measureAll(flags, *scene, *settings, *options, renderer, command);
}

} // namespace

void addTrade(CLI::App& program, const std::string& command, int& exitCode)
{
    auto flags = std::make_shared<TradeFlags>();
    CLI::App* verb = program.add_subcommand(
        "trade", "What every way of drawing this scene costs and loses against the double picture with 64 samples per "
                 "pixel: rungs alone and combined, the front, and the cheapest within a tolerance");
    addSceneOptions(*verb, flags->scene);
    verb->add_option("--tolerance", flags->wanted.tolerance,
                     "the largest error that is good enough: names the cheapest candidate; exit 1 if there is none");
    verb->add_option("--budget-ms", flags->wanted.milliseconds,
                     "instead: the time there is; names the most exact candidate within it; exit 1 if there is none");
    verb->add_flag("--dial", flags->dial,
                   "answer soon: look for it on a small probe, and verify what is found on the whole picture");
    verb->add_option("--map", flags->map,
                     "instead of all: paint each pixel by the cheapest surface that is within --tolerance there (PNG)");
    verb->add_flag(
        "--terms", flags->terms,
        "instead of all: what each term of the picture buys (diffuse, specular, lights, off-diagonal K) and costs");
    verb->add_option(
            "--metric", flags->metric,
            "max and rmse are linear, white 1, over the whole picture; de is the 95th percentile of dE2000 over "
            "the object")
        ->check(CLI::IsMember({"max", "rmse", "de"}))
        ->capture_default_str();
    verb->add_option("--cost", flags->cost, "ms of shading again (a drag) or of a view's first picture (frame)")
        ->check(CLI::IsMember({"shading", "frame"}))
        ->capture_default_str();
    verb->add_option("--only", flags->only, "try this rung alone, besides the arithmetics; repeat for more");
    verb->add_option("--repetitions", flags->repetitions, "timings of each candidate, interleaved")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    verb->add_option("--context", flags->context, "GL context: any, osmesa or egl")
        ->check(CLI::IsMember({"any", "osmesa", "egl"}))
        ->capture_default_str();
    verb->add_flag("--list", flags->list, "the rungs and what each gives up; measures nothing");
    verb->add_option("--html", flags->html, "write a report that needs nothing beside itself");
    verb->add_option("--svg", flags->svg, "write the chart alone");
    verb->add_option("--csv", flags->csv, "write all figures of all candidates");
    verb->add_option("--json", flags->json, "figures, to a file or - for standard output");
    verb->callback([flags, command, &exitCode] { exitCode = runTrade(*flags, command); });
}

} // namespace reflectance::cli
