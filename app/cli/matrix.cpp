// `matrix`: K from spectra, the best diagonal, and what each cheat costs in colour.
#include "app/cli/long_work.h"
#include "app/cli/matrix_report.h"
#include "app/cli/report.h"
#include "app/cli/scene_options.h"
#include "app/cli/verbs.h"
#include "core/base/text.h"
#include "core/spectra/builtin.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct Options {
    std::string reflectance = "colorchecker";
    std::string sensor = "nikon_d5100";
    std::string light = "display";
    std::string convention = "sensor";
    std::string balance;
    std::vector<std::string> under{"D65", "A", "FL2", "FL11", "LED3"};
    std::string object;
    std::string size;
    std::string json;
    bool list = false;
};

int listBuiltins()
{
    constexpr std::string_view roles[] = {"--reflectance", "--sensor", "--light, --under"};
    for (std::size_t role = 0; role < std::size(roles); ++role) {
        std::cout << roles[role] << '\n';
        for (const BuiltinSpectra& builtin : builtinSpectra())
            if (static_cast<std::size_t>(builtin.role) == role)
                std::cout << "    " << builtin.name
                          << std::string(20 - std::min<std::size_t>(builtin.name.size(), 19), ' ') << builtin.about
                          << "  [" << builtin.source << "]\n";
    }
    return Done;
}

Result<SpectrumTriple> sensorFrom(const Options& options)
{
    auto sensor = sensorNamed(options.sensor);
    if (!sensor || options.balance.empty())
        return sensor;
    const auto light = lightNamed(options.balance);
    if (!light)
        return light.error();
    return balanced(*std::move(sensor), *light);
}

Result<AlsoOnGrid> judgedFrom(const Options& options, std::vector<std::string>& warnings)
{
    AlsoOnGrid also;
    auto reflectances = reflectancesNamed(options.reflectance);
    if (!reflectances)
        return reflectances.error();
    for (const std::string& warning : reflectances->warnings)
        warnings.push_back(options.reflectance + ": " + warning);
    also.reflectances = std::move(reflectances->spectra);
    for (const std::string& name : options.under) {
        if (name == "none")
            continue;
        auto light = lightNamed(name);
        if (!light)
            return light.error();
        also.lights.push_back(*std::move(light));
    }
    return also;
}

/// Every spectrum that was named.
struct Inputs {
    SpectrumTriple sensor, primaries;
    AlsoOnGrid also;
};

Result<Inputs> inputsFrom(const Options& options, std::vector<std::string>& warnings)
{
    auto sensor = sensorFrom(options);
    if (!sensor)
        return sensor.error();
    auto primaries = primariesNamed(options.light);
    if (!primaries)
        return primaries.error();
    auto also = judgedFrom(options, warnings);
    if (!also)
        return also.error();
    return Inputs{*std::move(sensor), *std::move(primaries), *std::move(also)};
}

Result<MatrixFindings> findingsFrom(const Options& options, const Inputs& inputs, std::vector<std::string> warnings)
{
    MatrixFindings findings;
    findings.sensor = options.sensor;
    findings.light = options.light;
    findings.convention = options.convention == "primary" ? Convention::Primary : Convention::Sensor;
    findings.warnings = std::move(warnings);
    auto system = makeColorSystem(inputs.primaries, inputs.sensor, inputs.also);
    if (!system)
        return system.error();
    findings.system = *std::move(system);
    if (!findings.system.makesWhite)
        findings.warnings.push_back("these primaries cannot make this sensor's white: their gains would be " +
                                    general(findings.system.gain.x, 3) + ", " + general(findings.system.gain.y, 3) +
                                    ", " + general(findings.system.gain.z, 3) +
                                    "; they are left as given (--balance scales the sensor instead)");
    for (const Spectrum& reflectance : inputs.also.reflectances)
        findings.surfaces.push_back(judgedSurface(findings.system, reflectance));
    std::vector<JudgedLight> outside;
    for (const Spectrum& light : inputs.also.lights) {
        outside.push_back(judgedLight(findings.system, light));
        if (const Vec3d& seen = outside.back().seen; seen.x == 0.0 && seen.y == 0.0 && seen.z == 0.0)
            return Error{"the sensor sees nothing of the light '" + light.name + "'; leave it out of --under"};
    }
    findings.lights = lightsInSpan(findings.system);
    findings.inSpan = pricesOfCheats(findings.system, findings.surfaces, findings.lights);
    if (!outside.empty())
        findings.outside = pricesOfCheats(findings.system, findings.surfaces, outside);
    findings.lights.insert(findings.lights.end(), outside.begin(), outside.end());
    return findings;
}

/// The cheats on a picture of the object that was named, if one was.
Result<void> addObject(const Options& options, Inputs inputs, MatrixFindings& findings)
{
    if (options.object.empty())
        return {};
    if (findings.surfaces.size() != 1)
        return Error{"--object shows one surface and --reflectance names " + std::to_string(findings.surfaces.size()) +
                     "; choose one of them, such as --reflectance '" + findings.surfaces.front().name + "'"};
    SceneOptions sceneOptions;
    sceneOptions.input = options.object;
    sceneOptions.size = options.size;
    const auto settings = settingsFrom(sceneOptions, {128, 128, 1});
    if (!settings)
        return settings.error();
    const auto scene = sceneFrom(sceneOptions);
    if (!scene)
        return scene.error();
    // Pictures are floats: wavelengths beyond what they can tell apart would only take time.
    inputs.also.standsStill = 1e-7;
    const auto coarse = makeColorSystem(inputs.primaries, inputs.sensor, inputs.also);
    if (!coarse)
        return coarse.error();
    std::vector<JudgedLight> lights;
    for (const Spectrum& light : inputs.also.lights)
        lights.push_back(judgedLight(*coarse, light));
    auto prices = pricesOnObject(*scene, {settings->width, settings->height, 1}, *coarse,
                                 judgedSurface(*coarse, inputs.also.reflectances.front()), lights);
    if (!prices)
        return prices.error();
    findings.onObject = *std::move(prices);
    return {};
}

int run(const Options& options)
{
    if (options.list)
        return listBuiltins();
    std::vector<std::string> warnings;
    const auto inputs = inputsFrom(options, warnings);
    if (!inputs)
        return refused(inputs.error());
    auto findings = findingsFrom(options, *inputs, std::move(warnings));
    if (!findings)
        return refused(findings.error());
    if (const auto added = addObject(options, *inputs, *findings); !added)
        return refused(added.error(), LongWork::wasStopped() ? Stopped : BadInput);
    for (const std::string& warning : findings->warnings)
        std::cerr << "reflectance: " << warning << '\n';
    if (options.json != "-")
        print(std::cout, *findings);
    const auto written = writeReport(options.json, described(*findings));
    return written ? Done : refused(written.error());
}

} // namespace

void addMatrix(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb =
        program.add_subcommand("matrix", "K from spectra, the best diagonal, and the colour error of each");
    verb->add_option("--reflectance", options->reflectance, "the surfaces: a name of --list, or a CSV file")
        ->capture_default_str();
    verb->add_option("--sensor", options->sensor, "three filters: a name of --list, or a CSV file")
        ->capture_default_str();
    verb->add_option("--light", options->light,
                     "three primaries, or one light that is divided into bands: a name of --list, or a CSV file")
        ->capture_default_str();
    verb->add_option("--convention", options->convention,
                     "whose numbers the light has: primary (K = M) or sensor (K = M W^-1)")
        ->check(CLI::IsMember({"primary", "sensor"}))
        ->capture_default_str();
    verb->add_option("--balance", options->balance, "scale the filters so that this light on white is (1,1,1)");
    verb->add_option("--under", options->under, "lights beyond the primaries to judge under, or none")
        ->capture_default_str();
    verb->add_option("--object", options->object,
                     "mesh or scene: price the cheats on its picture too, against one integrated over wavelength");
    verb->add_option("--size", options->size, "of that picture, WxH (128x128)");
    verb->add_option("--json", options->json, "all figures, to a file or - for standard output");
    verb->add_flag("--list", options->list, "the spectra that the program carries, with their sources");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
