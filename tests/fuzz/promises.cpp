#include "tests/fuzz/promises.h"

#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <cmath>

namespace reflectance::fuzz {
namespace {

/// The longest sentences list every model or every mesh by name.
constexpr std::size_t longestSentence = 800;

bool isFinite(const Vec3d& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isOneLine(const std::string& text)
{
    return std::none_of(text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; });
}

std::string brokenIndex(const Mesh& mesh)
{
    for (const Mesh::Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            if (v >= mesh.positions.size())
                return "an index past the last position";
    for (const std::uint32_t v : mesh.fileVertex)
        if (v >= mesh.fileVertexCount)
            return "a vertex from outside the file";
    return {};
}

std::string brokenVector(const Mesh& mesh)
{
    // Centre, scale and division round a handful of times, also where the file's coordinates are subnormal.
    for (const Vec3d& p : mesh.positions)
        if (!isFinite(p) || length(p) > 1.0 + 1e-12)
            return "a position that is not finite or outside the unit sphere";
    for (const Vec3d& n : mesh.normals)
        if (!(std::abs(length(n) - 1.0) <= 1e-15)) // three roundings of a unit vector
            return "a normal that is no unit vector";
    if (!isFinite(mesh.placement.centre) || !(mesh.placement.scale > 0.0) || !std::isfinite(mesh.placement.scale))
        return "a placement that cannot be undone";
    return {};
}

} // namespace

std::string brokenPromise(const Error& refusal)
{
    const std::string sentence = refusal.sentence();
    if (refusal.message.size() < 10)
        return "a refusal without a sentence";
    if (!isOneLine(sentence))
        return "a refusal of several lines or with control characters";
    if (sentence.size() > longestSentence)
        return "a refusal of " + std::to_string(sentence.size()) + " characters";
    return {};
}

std::string brokenPromise(const LoadedMesh& loaded, std::size_t bytes)
{
    const Mesh& mesh = *loaded.mesh;
    if (mesh.triangles.empty() || mesh.triangles.size() != loaded.report.triangles)
        return "triangles that are not those of the report";
    if (mesh.triangles.size() > bytes || mesh.positions.size() > 3 * mesh.triangles.size() ||
        mesh.fileVertexCount > bytes)
        return "more mesh than the file can hold";
    if (mesh.normals.size() != mesh.positions.size() || mesh.fileVertex.size() != mesh.positions.size())
        return "not one normal and one origin per position";
    for (const MeshWarning& warning : loaded.report.warnings)
        if (!isOneLine(warning.text) || warning.text.size() > longestSentence)
            return "a warning that is no short line";
    const std::string index = brokenIndex(mesh);
    return index.empty() ? brokenVector(mesh) : index;
}

std::string brokenPromise(const Image& image, std::size_t bytes)
{
    constexpr std::size_t bestCompression = 16384;
    if (image.width < 1 || image.height < 1 || image.rgb.size() != 3 * image.pixels())
        return "values that do not fit the size";
    if (!image.coverage.empty() && image.coverage.size() != image.pixels())
        return "coverage that does not fit the size";
    return image.pixels() > bestCompression * bytes ? "more picture than the file can hold" : "";
}

std::string brokenPromise(const Scene& scene)
{
    if (!scene.mesh || scene.mesh->triangles.empty())
        return "a scene without a mesh";
    if (!findModel(scene.surface.model))
        return "a model that does not exist";
    for (const double value : valuesOf(scene))
        if (!std::isfinite(value))
            return "a parameter that is not finite";
    for (const Light& light : scene.lights) {
        const Vec3d& I = light.intensity;
        if (!isFinite(I) || I.x < 0.0 || I.y < 0.0 || I.z < 0.0)
            return "an intensity that is negative or not finite";
        if (!isFinite(light.position) || !isFinite(light.direction) || normalized(light.direction) == Vec3d())
            return "a light from nowhere";
        if (!(light.angularRadius >= 0.0 && light.angularRadius <= 90.0))
            return "a light's radius outside 0 .. 90 degrees";
    }
    const Camera& camera = scene.camera;
    if (!isFinite(camera.eye) || !isFinite(camera.target) || !isFinite(camera.up))
        return "a camera that is nowhere";
    if (scene.sensor.response.on && scene.sensor.response.kind == ResponseKind::Curve && !scene.sensor.response.curve)
        return "a response curve without its curve";
    return std::isfinite(gainOf(scene.sensor)) ? "" : "an exposure that is not finite";
}

std::string brokenPromise(const cli::EvalRows& rows)
{
    for (const Error& bad : rows.bad)
        if (const std::string broken = brokenPromise(bad); !broken.empty())
            return broken;
    for (const cli::EvalRow& row : rows.rows) {
        if (!row.model || row.values.size() != row.model->text.valueCount())
            return "not one value per slot of the model";
        if (!isFinite(row.observation.N) || !isFinite(row.observation.V) || row.observation.lights.empty())
            return "a row with a vector that is not finite, or without light";
        for (const ObservedLight& light : row.observation.lights)
            if (!isFinite(light.L) || !isFinite(light.I))
                return "a light that is not finite";
    }
    return {};
}

std::string brokenPromise(const ModelText& text)
{
    if (text.code.find("vec3 shade(") == std::string::npos)
        return "a model that shades nothing";
    std::size_t offset = 0;
    for (const Parameter& parameter : text.parameters) {
        const std::size_t given = parameter.initial.size();
        const bool isList = parameter.kind == ParameterKind::List; // its default may be shorter than its longest form
        if (parameter.offset != offset || given == 0 || given > parameter.size || (!isList && given != parameter.size))
            return "a parameter whose values are not where they should be";
        offset += parameter.size;
    }
    return {};
}

std::string brokenPromise(const Model& model)
{
    // That it ends is the promise: the fuzzer's time limit would notice.
    const Observation row{{0, 0, 1}, {0.6, 0, 0.8}, {{{0, 0.6, 0.8}, {1, 1, 1}, 0}}};
    (void)evaluate(model, flatValues(model.text, {}), std::span(&row, 1), Precision::Double);
    return brokenPromise(model.text);
}

} // namespace reflectance::fuzz
