// `bench`: what shading, frames and loading cost here, with the machine and the conditions stated.
#include "app/cli/long_work.h"
#include "app/cli/report.h"
#include "app/cli/scene_options.h"
#include "app/cli/verbs.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/render/pictures/render_picture.h"
#include "core/study/bench/growth.h"
#include "core/study/cost/machine.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    SceneOptions scene;
    std::string context = "any";
    bool quick = false;
    std::string growth;
    std::string json;
};

Json described(const Timing& timing)
{
    return {{"median", timing.median}, {"spread", timing.spread}, {"repetitions", timing.repetitions}};
}

/// "12.3 +- 0.4"
std::string text(const Timing& timing)
{
    return general(timing.median, 3) + " \u00b1 " + general(timing.spread, 1);
}

class Table {
public:
    explicit Table(bool shown) : shown_(shown) {}

    void heading(const std::string& title) const
    {
        if (shown_)
            std::cout << '\n' << title << '\n';
    }
    void row(const std::string& name, const std::string& kind, const std::string& value) const
    {
        if (shown_)
            std::cout << "    " << std::left << std::setw(34) << name << std::setw(15) << kind << value << std::endl;
    }

private:
    bool shown_;
};

Json kernels(const BenchEffort& effort, Table& table)
{
    const LongWork work;
    const auto costs = kernelCosts(effort, LongWork::progress());
    Json rows = Json::array();
    table.heading("ns per shading, one core, batches of " + std::to_string(effort.rows) + " directions");
    for (const KernelCost& cost : costs) {
        table.row(cost.model, cost.precision, text(cost.nanoseconds));
        rows.push_back({{"model", cost.model}, {"precision", cost.precision}, {"ns", described(cost.nanoseconds)}});
    }
    return rows;
}

Result<Json> frames(const Options& options, const BenchEffort& effort, GlRenderer* gl, Table& table)
{
    const auto scene = sceneFrom(options.scene);
    if (!scene)
        return scene.error();
    const auto settings = settingsFrom(options.scene, {options.quick ? 128 : 1024, options.quick ? 128 : 1024, 1});
    if (!settings)
        return settings.error();
    const LongWork work;
    const auto costs = frameCosts(*scene, *settings, gl, effort, LongWork::progress());
    if (!costs)
        return costs.error();
    Json rows = Json::array();
    table.heading("ms per picture of " + std::to_string(settings->width) + "x" + std::to_string(settings->height) +
                  ", " + std::to_string(scene->mesh->triangles.size()) + " triangles, " + scene->surface.model +
                  ": shading again (first frame)");
    for (const FrameCost& cost : costs.value()) {
        table.row(scene->surface.model, cost.renderer, text(cost.shading) + "   (" + general(cost.firstFrame, 3) + ")");
        rows.push_back({{"renderer", cost.renderer},
                        {"shading_ms", described(cost.shading)},
                        {"first_frame_ms", cost.firstFrame}});
    }
    return rows;
}

Json loads(const BenchEffort& effort, Table& table)
{
    const LongWork work;
    Json rows = Json::array();
    table.heading("MB/s, from bytes in memory to a mesh that can be drawn");
    for (const LoadCost& cost : loadCosts(effort, LongWork::progress())) {
        table.row(cost.format, std::to_string(cost.triangles),
                  general(cost.megabytesPerSecond(), 3) + "   (" + text(cost.milliseconds) + " ms)");
        rows.push_back({{"format", cost.format},
                        {"triangles", cost.triangles},
                        {"megabytes", cost.megabytes},
                        {"ms", described(cost.milliseconds)},
                        {"megabytes_per_second", cost.megabytesPerSecond()}});
    }
    return rows;
}

Result<Json> growing(const Options& options, GlRenderer* gl, Table& table)
{
    const LongWork work;
    const auto measured = growths(gl, options.quick, LongWork::progress());
    if (!measured)
        return measured.error();
    Json rows = Json::array();
    table.heading("growth: cost is in proportion to size to this power");
    for (const Growth& growth : measured.value()) {
        table.row(growth.with, "", general(growth.exponent(), 3) + "   (" + growth.cost + ")");
        Json points = Json::array();
        for (std::size_t i = 0; i < growth.sizes.size(); ++i)
            points.push_back({{"size", growth.sizes[i]}, {"ms", described(growth.milliseconds[i])}});
        rows.push_back(
            {{"with", growth.with}, {"cost", growth.cost}, {"exponent", growth.exponent()}, {"points", points}});
    }
    const Chart chart = chartOf(measured.value());
    const auto written =
        writeAtomically(options.growth, options.growth.ends_with(".csv") ? csvOf(chart) : svgOf(chart, 1000, 640));
    return written ? Result<Json>(rows) : written.error();
}

Result<Json> measured(const Options& options, GlRenderer* gl, Table& table)
{
    const BenchEffort effort = options.quick ? quickEffort() : BenchEffort();
    const Machine machine = thisMachine(gl != nullptr ? gl->description() : "");
    table.heading(sentenceOf(machine) + "; median of " + std::to_string(effort.repetitions) +
                  " interleaved repetitions \u00b1 half the distance between the quartiles");
    Json report{{"machine", sentenceOf(machine)}, {"quick", options.quick}};
    if (!options.growth.empty()) {
        const auto grown = growing(options, gl, table);
        if (!grown)
            return grown.error();
        report["growth"] = *grown;
        return report;
    }
    report["kernels"] = kernels(effort, table);
    if (LongWork::wasStopped())
        return report;
    const auto pictures = frames(options, effort, gl, table);
    if (!pictures)
        return pictures.error();
    report["frames"] = *pictures;
    if (!LongWork::wasStopped())
        report["loads"] = loads(effort, table);
    return report;
}

int run(const Options& options)
{
    if (!options.growth.empty() && !options.growth.ends_with(".svg") && !options.growth.ends_with(".csv"))
        return refused(Error{"--growth writes a chart or its numbers; name the file .svg or .csv"});
    for (const std::string& file : {options.growth, options.json})
        if (const auto writable = checkWritable(file); !writable && !file.empty() && file != "-")
            return refused(writable.error());
    auto context = openHeadless(contextNamed(options.context));
    std::optional<GlRenderer> gl;
    if (context)
        if (auto made = GlRenderer::create((*context)->loader()))
            gl.emplace(*std::move(made));
    Table table(options.json != "-");
    const auto report = measured(options, gl ? &*gl : nullptr, table);
    if (!report)
        return refused(report.error());
    if (LongWork::wasStopped())
        return refused(Error{"stopped; nothing was written"}, Stopped);
    const auto written = writeReport(options.json, *report);
    return written ? Done : refused(written.error());
}

} // namespace

void addBench(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb =
        program.add_subcommand("bench", "What shading, frames and loading cost on this machine, by median and spread");
    addSceneOptions(*verb, options->scene);
    verb->add_option("--context", options->context, "GL context: any, osmesa or egl")
        ->check(CLI::IsMember({"any", "osmesa", "egl"}))
        ->capture_default_str();
    verb->add_flag("--quick", options->quick, "small batches and few repetitions: seconds, and rough figures");
    verb->add_option("--growth", options->growth,
                     "cost against triangles, pixels, lights, samples and table size instead, as .svg or .csv");
    verb->add_option("--json", options->json, "all figures as JSON, to a file or - for standard output");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
