// `compare A B`: metrics between two pictures. `compare SCENE`: the price tag - what float, SIMD and GL cost on this
// scene and how far they are from double.
#include "app/cli/compare_pictures.h"
#include "app/cli/report.h"
#include "app/cli/scene_options.h"
#include "app/cli/verbs.h"
#include "core/base/text.h"
#include "core/study/price_tag.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct Options {
    SceneOptions scene;
    std::string second;
    CompareOptions pictures;
};

void printTags(const std::vector<PriceTag>& tags)
{
    std::printf("%-16s %12s %14s %14s\n", "arithmetic", "shading ms", "max error", "RMSE");
    for (const PriceTag& tag : tags)
        std::printf("%-16s %12.3f %14.3g %14.3g\n", tag.name.c_str(), tag.milliseconds, tag.maxError, tag.rmse);
    std::puts("errors: linear channels against the double picture of the same samples");
}

nlohmann::ordered_json described(const std::vector<PriceTag>& tags)
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PriceTag& tag : tags)
        list.push_back(
            {{"name", tag.name}, {"shading_ms", tag.milliseconds}, {"max_error", tag.maxError}, {"rmse", tag.rmse}});
    return {{"price_tags", list}};
}

int priceTagOf(const Options& options)
{
    const auto settings = settingsFrom(options.scene, {512, 512, 2});
    if (!settings)
        return refused(settings.error());
    const auto scene = sceneFrom(options.scene);
    if (!scene)
        return refused(scene.error());
    const auto context = openHeadless(ContextKind::Any);
    std::optional<GlRenderer> gl;
    if (context)
        if (auto renderer = GlRenderer::create((*context)->loader()))
            gl = *std::move(renderer);
    if (!gl)
        std::cerr << "reflectance: no GL context opens here, so gl has no price tag\n";
    const std::vector<PriceTag> tags = priceTags(*scene, *settings, gl ? &*gl : nullptr);
    if (options.pictures.json != "-")
        printTags(tags);
    const auto written = writeReport(options.pictures.json, described(tags));
    return written ? Done : refused(written.error());
}

} // namespace

void addCompare(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb =
        program.add_subcommand("compare", "Two pictures: how far apart they are. One scene or mesh: what float, SIMD "
                                          "and GL cost on it and how far they are from double");
    addSceneOptions(*verb, options->scene);
    verb->get_option("input")->description("first picture (.png, .exr, .pfm, .hdr), or a scene or mesh alone");
    verb->add_option("second", options->second, "second picture");
    verb->add_option("--threshold", options->pictures.threshold,
                     "exit 1 if the largest absolute difference exceeds this")
        ->check(CLI::NonNegativeNumber);
    verb->add_option("--diff", options->pictures.diff, "write the difference as a PNG");
    verb->add_option("--json", options->pictures.json, "figures, to a file or - for standard output");
    verb->callback([options, &exitCode] {
        exitCode = options->second.empty() ? priceTagOf(*options)
                                           : comparePictures(options->scene.input, options->second, options->pictures);
    });
}

} // namespace reflectance::cli
