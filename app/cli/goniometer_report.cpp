#include "app/cli/goniometer_report.h"

#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/measured/facts.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string anglesText(const LabRun& run, std::size_t cell)
{
    const auto& axes = run.setup.shape.axes;
    return "theta_i " + general(degrees(axes[0][cell / axes[2].size() / axes[1].size()]), 4) + ", theta_r " +
           general(degrees(axes[1][cell / axes[2].size() % axes[1].size()]), 4) + ", delta_phi " +
           general(degrees(axes[2][cell % axes[2].size()]), 4);
}

std::string percent(double share)
{
    return general(100.0 * share, 3) + " %";
}

constexpr double albedoAngles[] = {0.0, 30.0, 60.0};

Json gapOf(const LabRun& run, const Compared& compared)
{
    return {{"model", compared.name},
            {"rms", compared.gap.rms},
            {"noise", compared.gap.noise},
            {"mean", compared.gap.mean},
            {"worst_factor", compared.gap.worst},
            {"worst_at", anglesText(run, compared.gap.worstCell)}};
}

} // namespace

void print(const LabRun& run, const MicroSurface& surface, const std::optional<Compared>& compared)
{
    const LabSetup& setup = run.setup;
    std::printf("%s: %zu patch%s, %zu triangles, rms slope %s; facets %s\n", surface.text.c_str(),
                surface.patches.size(), surface.patches.size() == 1 ? "" : "es", surface.triangles(),
                general(surface.slope(), 4).c_str(), setup.model.c_str());
    std::printf("%s%s, up to %d interreflections; %s\n", setup.effects.masking ? "masking" : "no masking",
                setup.effects.shadowing ? ", shadowing" : ", no shadowing", setup.effects.bounces,
                setup.azimuth ? ("turned by " + general(degrees(*setup.azimuth), 4) + " degrees").c_str()
                              : "an isotropic mixture of all azimuths");
    const LabErrors errors = errorsFound(run);
    std::printf("%zu cells, %.4g paths; standard error over the rms of f: typically %s, at most %s at %s\n",
                run.cells.size(), static_cast<double>(run.paths()), percent(errors.typical).c_str(),
                percent(errors.largest).c_str(), anglesText(run, errors.worstCell).c_str());
    if (run.lost > 0)
        std::printf("%llu rays fell through the surface by rounding and count as black\n",
                    static_cast<unsigned long long>(run.lost));
    const Measurement table = tableOf(run);
    std::printf("albedo");
    for (const double angle : albedoAngles) {
        const Vec3d albedo = albedoAt(table, radians(angle)).value;
        std::printf("%s %.0f degrees: %s", angle > 0.0 ? ";" : "", angle, general(albedo.x, 4).c_str());
        if (setup.channels > 1)
            std::printf(" %s %s", general(albedo.y, 4).c_str(), general(albedo.z, 4).c_str());
    }
    std::printf("\n");
    if (compared)
        std::printf("%s is off by %s rms, of which the errors make %s; %s%s in the mean; at most %s of pi f "
                    "cos(theta_i) at %s\n",
                    compared->name.c_str(), percent(compared->gap.rms).c_str(), percent(compared->gap.noise).c_str(),
                    compared->gap.mean < 0.0 ? "" : "+", percent(compared->gap.mean).c_str(),
                    general(compared->gap.worst, 3).c_str(), anglesText(run, compared->gap.worstCell).c_str());
}

Json described(const LabRun& run, const MicroSurface& surface, const std::optional<Compared>& compared)
{
    const LabSetup& setup = run.setup;
    const LabErrors errors = errorsFound(run);
    Json albedos = Json::array();
    const Measurement table = tableOf(run);
    for (const double angle : albedoAngles) {
        const Albedo albedo = albedoAt(table, radians(angle));
        albedos.push_back({{"theta_i", angle}, {"value", {albedo.value.x, albedo.value.y, albedo.value.z}}});
    }
    Json report{{"surface", surface.text},
                {"patches", surface.patches.size()},
                {"triangles", surface.triangles()},
                {"rms_slope", surface.slope()},
                {"model", setup.model},
                {"values", setup.values},
                {"channels", setup.channels},
                {"bounces", setup.effects.bounces},
                {"masking", setup.effects.masking},
                {"shadowing", setup.effects.shadowing},
                {"azimuth", setup.azimuth ? Json(degrees(*setup.azimuth)) : Json(nullptr)},
                {"seed", setup.seed},
                {"cells", run.cells.size()},
                {"paths", run.paths()},
                {"lost", run.lost},
                {"error",
                 {{"typical", errors.typical}, {"largest", errors.largest}, {"at", anglesText(run, errors.worstCell)}}},
                {"albedo", albedos}};
    if (compared)
        report["against"] = gapOf(run, *compared);
    return report;
}

} // namespace reflectance::cli
