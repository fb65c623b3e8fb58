#include "core/study/probe/probe.h"

#include "core/math/lobe.h"
#include "core/reflectance/walked/dissected.h"
#include "core/render/cpu/surface_point.h"
#include "core/sensor/sensor.h"
#include "core/study/probe/triangle_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// The scene's formula and its parts, ready to be asked.
struct Asked {
    const Model* model = nullptr;
    std::vector<double> values;
    MeasuredSurfaces measured;
    std::shared_ptr<const walked::Dissected> parts;
};

Asked askedOf(const Scene& scene)
{
    const Model& model = modelOf(scene);
    return {&model, valuesOf(scene), lookUpsIn(scene.surface.table.get()), walked::dissected(model.text)};
}

/// As the renderer has it, the order of its operations included.
void arrive(const Light& light, const Vec3d& P, ProbedLight& probed)
{
    const Arrival arrival = arrivalAt(light, P);
    probed.L = arrival.L;
    probed.I = arrival.I;
    if (light.kind != LightKind::Point)
        return;
    probed.distance = length(light.position - P);
    const double r = std::max(probed.distance, smallestLightDistance);
    probed.I = light.intensity * (probed.distance > 0.0 ? 1.0 / (r * r) : 0.0);
}

Vec3d shaded(const Model& model, const Asked& asked, const walked::Place& place)
{
    const Vec3d& N = place.N;
    const Vec3d& L = place.L;
    const Vec3d& V = place.V;
    const Vec3d& I = place.I;
    Vec3d sum;
    model.exact.shade(asked.values.data(), {1,
                                            {&N.x, &N.y, &N.z},
                                            {&L.x, &L.y, &L.z},
                                            {&V.x, &V.y, &V.z},
                                            {&I.x, &I.y, &I.z},
                                            &place.lightDisc,
                                            {&sum.x, &sum.y, &sum.z},
                                            asked.measured.exact});
    return sum;
}

ProbedLight probedLight(const Light& light, std::size_t index, const Probe& probe, const Asked& asked)
{
    ProbedLight probed;
    probed.index = index;
    probed.name = light.name;
    probed.kind = light.kind;
    probed.sent = light.intensity;
    arrive(light, probe.point.P, probed);
    const Vec3d& N = probe.point.N;
    probed.R = mirrored(N, probed.L);
    probed.cosine = dot(N, probed.L);
    probed.mirrorCosine = dot(probed.R, probe.V);
    const walked::Place place{N, probed.L, probe.V, probed.I, discOf(light), asked.measured.exact};
    probed.value = shaded(*asked.model, asked, place);
    probed.account = walked::accountOf(asked.parts->tree, asked.values, place);
    for (std::size_t i = 0; i < asked.parts->alone.size(); ++i) {
        const walked::Term& term = asked.parts->terms[i];
        probed.terms.push_back({term.name, term.source, shaded(*asked.parts->alone[i], asked, place)});
    }
    return probed;
}

Vec3d radianceThere(const void* environment, const Vec3d& direction)
{
    return radianceFrom(*static_cast<const Environment*>(environment), direction);
}

void addSurroundings(const Scene& scene, const Asked& asked, Probe& probe)
{
    if (asked.model->exact.environment == nullptr || scene.environment.kind == EnvironmentKind::None)
        return;
    const Vec3d& N = probe.point.N;
    const Vec3d& V = probe.V;
    const Vec3d before = probe.value;
    Vec3d& sum = probe.value;
    asked.model->exact.environment(
        asked.values.data(),
        {1, {&N.x, &N.y, &N.z}, {&V.x, &V.y, &V.z}, {radianceThere, &scene.environment}, {&sum.x, &sum.y, &sum.z}});
    probe.surroundings = sum - before;
}

/// By the sensor's own chain, which asks where in the picture a pixel lies; the picture holds floats.
void develop(const Sensor& sensor, Probe& probe)
{
    const ProbedPoint& point = probe.point;
    const auto inside = [](double at, int size) { return std::clamp(static_cast<int>(std::floor(at)), 0, size - 1); };
    const int x = inside(point.x, point.width), y = inside(point.y, point.height);
    Image image(point.width, point.height);
    const Vec3f value(probe.value);
    float* const pixel = image.at(x, y);
    pixel[0] = value.x;
    pixel[1] = value.y;
    pixel[2] = value.z;
    probe.gain = gainOf(sensor);
    probe.exposed = probe.value * probe.gain;
    probe.encoded = developedAt(image, x, y, sensor);
    const double exposed[] = {probe.exposed.x, probe.exposed.y, probe.exposed.z};
    const double encoded[] = {probe.encoded.x, probe.encoded.y, probe.encoded.z};
    for (std::size_t i = 0; i < 3; ++i) {
        probe.clipped[i] = !(exposed[i] >= 0.0 && exposed[i] <= 1.0);
        probe.codes[i] = quantised(encoded[i]);
    }
}

/// To the triangle along the ray, from either side; infinite where it is missed. Moller and Trumbore, 1997.
double distanceAlong(const Mesh& mesh, std::size_t triangle, const Vec3d& eye, const Vec3d& direction)
{
    const auto& corners = mesh.triangles[triangle];
    const Vec3d a = mesh.positions[corners[0]];
    const Vec3d ab = mesh.positions[corners[1]] - a, ac = mesh.positions[corners[2]] - a;
    const Vec3d across = cross(direction, ac);
    const double determinant = dot(ab, across);
    const Vec3d toEye = eye - a;
    const double u = dot(toEye, across) / determinant;
    const Vec3d around = cross(toEye, ab);
    const double v = dot(direction, around) / determinant;
    const double t = dot(ac, around) / determinant;
    // A ray along the triangle divides by 0 and fails one of these.
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : std::numeric_limits<double>::infinity();
}

struct ImagePoint {
    double x, y;
    int width, height;
};

/// The nearest of the triangles that candidates(eye, direction, visit) visits in ascending order.
template <class Candidates>
std::optional<ProbedPoint> nearestPoint(const Mesh& mesh, const Camera& camera, const ImagePoint& at,
                                        const Candidates& candidates)
{
    const Vec3d direction = rayThrough(camera, at.x, at.y, at.width, at.height);
    std::optional<std::uint32_t> first;
    double nearest = std::numeric_limits<double>::infinity();
    candidates(camera.eye, direction, [&](std::size_t i) {
        if (const double t = distanceAlong(mesh, i, camera.eye, direction); t < nearest) {
            nearest = t;
            first = static_cast<std::uint32_t>(i);
        }
    });
    if (!first)
        return std::nullopt;
    const SurfacePoint point = surfacePoint(mesh, *first, camera.eye, direction);
    return ProbedPoint{at.x, at.y, at.width, at.height, point.P, point.N, *first};
}

std::string conventionOf(const Scene& scene, const Model& model)
{
    const auto& parameters = model.text.parameters;
    if (std::none_of(parameters.begin(), parameters.end(),
                     [](const Parameter& p) { return p.kind == ParameterKind::Matrix; }))
        return {};
    return scene.surface.convention == Convention::Sensor
               ? "K and I in the sensor convention"
               : "K and I in the sensor convention, turned into it by W from the primary convention of the scene";
}

} // namespace

std::optional<ProbedPoint> pointAt(const Mesh& mesh, const Camera& camera, double x, double y, int width, int height)
{
    const auto all = [&](const Vec3d&, const Vec3d&, const auto& visit) {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            visit(i);
    };
    return nearestPoint(mesh, camera, {x, y, width, height}, all);
}

std::optional<ProbedPoint> pointAt(const std::shared_ptr<const Mesh>& mesh, const Camera& camera, double x, double y,
                                   int width, int height)
{
    const std::shared_ptr<const TriangleRuns> runs = runsOf(mesh);
    const auto near = [&](const Vec3d& eye, const Vec3d& direction, const auto& visit) {
        runs->along(eye, direction, visit);
    };
    return nearestPoint(*mesh, camera, {x, y, width, height}, near);
}

Probe probeAt(const Scene& scene, const ProbedPoint& point)
{
    const Asked asked = askedOf(scene);
    Probe probe;
    probe.point = point;
    probe.model = asked.model->text.name;
    probe.formula = asked.model->text.formula;
    probe.convention = conventionOf(scene, *asked.model);
    const Vec3d toEye = scene.camera.eye - point.P;
    probe.V = normalized(toEye);
    probe.distance = length(toEye);
    probe.NV = dot(point.N, probe.V);
    std::vector<std::size_t> on;
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].on)
            on.push_back(i);
    const std::vector<Light> lights = shiningLights(scene);
    for (const LightKind kind : {LightKind::Directional, LightKind::Point})
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (lights[i].kind == kind) {
                probe.lights.push_back(probedLight(lights[i], on[i], probe, asked));
                probe.value += probe.lights.back().value;
            }
    addSurroundings(scene, asked, probe);
    develop(scene.sensor, probe);
    return probe;
}

} // namespace reflectance
