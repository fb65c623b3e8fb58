#include "core/scene/scene_file.h"

#include "core/base/file.h"
#include "core/scene/scene_json.h"

#include <filesystem>

namespace reflectance {
namespace {

using Json = ObjectReader::Json;
namespace fs = std::filesystem;

bool isUtf8(const std::string& text)
{
    return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::ignore)) == Json(text);
}

/// Every file that the scene names; empty names stand for none.
std::vector<std::string> filesOf(const Scene& scene)
{
    std::vector<std::string> files{scene.meshFile, scene.environment.file, scene.surface.tableFile,
                                   scene.surface.modelFile, scene.sensor.response.file};
    if (scene.other)
        files.insert(files.end(), {scene.other->tableFile, scene.other->modelFile});
    for (const KeptSurface& variant : scene.variants)
        files.insert(files.end(), {variant.surface.tableFile, variant.surface.modelFile});
    return files;
}

} // namespace

std::string sceneText(const Scene& scene, const std::string& folder)
{
    return jsonText(sceneJson(scene, {folder}));
}

Result<Scene> parseScene(std::string_view text, const std::string& file, const std::string& folder)
{
    const auto json = parsedJson(text, "a JSON scene", file);
    if (!json)
        return json.error();
    Scene scene = defaultScene();
    std::optional<std::string> problem;
    readScene(ObjectReader(*json, "scene", problem), scene, {folder});
    if (problem)
        return Error{*problem, file};
    return scene;
}

Result<Scene> loadScene(const std::string& path)
{
    const auto text = readWholeFile(path);
    if (!text)
        return text.error();
    return parseScene(*text, path, fs::path(path).parent_path().string());
}

Result<void> saveScene(const Scene& scene, const std::string& path)
{
    for (const std::string& file : filesOf(scene))
        if (!isUtf8(file))
            return Error{"a scene file cannot name this file, since its name is not UTF-8; rename it", file};
    return writeAtomically(path, sceneText(scene, fs::path(path).parent_path().string()));
}

} // namespace reflectance
