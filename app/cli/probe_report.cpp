#include "app/cli/probe_report.h"

#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

Json array(const Vec3d& v)
{
    return {v.x, v.y, v.z};
}

Json described(const ProbedLight& light)
{
    Json steps = Json::array();
    for (const walked::AccountLine& line : light.account.lines)
        steps.push_back({{"line", line.line},
                         {"name", line.name},
                         {"expression", line.expression},
                         {"filled", line.filled},
                         {"value", line.numbers},
                         {"notes", line.notes}});
    Json terms = Json::array();
    for (const ProbedTerm& term : light.terms)
        terms.push_back({{"name", term.name}, {"source", term.source}, {"value", array(term.value)}});
    return {{"index", light.index + 1}, {"name", light.name},        {"L", array(light.L)},       {"I", array(light.I)},
            {"R", array(light.R)},      {"N.L", light.cosine},       {"R.V", light.mirrorCosine}, {"steps", steps},
            {"terms", terms},           {"adds", array(light.value)}};
}

} // namespace

Json probeReport(const Probe& probe)
{
    Json lights = Json::array();
    for (const ProbedLight& light : probe.lights)
        lights.push_back(described(light));
    Json json{{"pixel", {probe.point.x, probe.point.y}},
              {"model", probe.model},
              {"P", array(probe.point.P)},
              {"N", array(probe.point.N)},
              {"V", array(probe.V)},
              {"N.V", probe.NV},
              {"lights", lights}};
    if (probe.surroundings)
        json["surroundings"] = array(*probe.surroundings);
    json["sum"] = array(probe.value);
    json["exposed"] = array(probe.exposed);
    json["clipped"] = probe.clipped;
    json["encoded"] = array(probe.encoded);
    json["codes"] = probe.codes;
    return json;
}

} // namespace reflectance::cli
