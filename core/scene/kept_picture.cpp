#include "core/scene/kept_picture.h"

#include "core/base/file.h"
#include "core/base/version.h"
#include "core/image/picture_file.h"
#include "core/reflectance/lobe_form.h"
#include "core/scene/scene_json.h"

#include <filesystem>

namespace reflectance {
namespace {

using Json = ObjectReader::Json;
namespace fs = std::filesystem;

constexpr const char* noteKey = "reflectance.session";
constexpr const char* pictureSchema = "reflectance.picture";
constexpr int pictureVersion = 1;
constexpr int mostPixels = 16384;

constexpr NamedValue<VariantView> shownNames[] = {{"A", VariantView::A},
                                                  {"B", VariantView::B},
                                                  {"side", VariantView::SideBySide},
                                                  {"wipe", VariantView::Wipe},
                                                  {"difference", VariantView::Difference}};
constexpr NamedValue<int> backends[] = {{"gl", 0}, {"cpu", 1}};
constexpr NamedValue<int> precisions[] = {{"glsl", 0}, {"double", 1}, {"float", 2}, {"simd", 3}};
constexpr NamedValue<int> lenses[] = {{"none", 0}, {"float", 1}, {"half", 2}, {"simd", 3}, {"glsl", 4}};
constexpr NamedValue<int> shadings[] = {{"pixel", 0}, {"once", 1}, {"vertex", 2}, {"face", 3}, {"fragment", 4}};

std::string wholePath(const std::string& folder)
{
    std::error_code failed;
    const fs::path here = fs::current_path(failed);
    return failed ? folder : (here / folder).lexically_normal().string();
}

Json written(const PictureRecipe& recipe)
{
    Json json{{"width", recipe.width},
              {"height", recipe.height},
              {"samples", recipe.samplesPerAxis * recipe.samplesPerAxis},
              {"backend", recipe.backend},
              {"precision", recipe.precision},
              {"shading", recipe.shading},
              {"shows", nameOf(recipe.shown)},
              {"divider", recipe.divider},
              {"holes", recipe.holes},
              {"lens", recipe.lens},
              {"lobe", recipe.lobe}};
    if (!recipe.term.empty())
        json["term"] = recipe.term;
    return json;
}

/// A word out of a list, as a word.
template <std::size_t count>
void readWord(ObjectReader& object, const char* key, const NamedValue<int> (&names)[count], std::string& word)
{
    int value = 0;
    for (const NamedValue<int>& named : names)
        if (named.name == word)
            value = named.value;
    object.readNamed(key, names, value);
    word = names[static_cast<std::size_t>(value)].name;
}

void readRecipe(ObjectReader object, PictureRecipe& recipe)
{
    object.read("width", recipe.width, 1, mostPixels);
    object.read("height", recipe.height, 1, mostPixels);
    int samples = recipe.samplesPerAxis * recipe.samplesPerAxis;
    object.read("samples", samples, 1, 64);
    recipe.samplesPerAxis = 1;
    while (recipe.samplesPerAxis * recipe.samplesPerAxis < samples)
        ++recipe.samplesPerAxis;
    if (recipe.samplesPerAxis * recipe.samplesPerAxis != samples)
        object.fail("picture.samples must be a square number");
    readWord(object, "backend", backends, recipe.backend);
    readWord(object, "precision", precisions, recipe.precision);
    readWord(object, "shading", shadings, recipe.shading);
    readWord(object, "lens", lenses, recipe.lens);
    object.read("lobe", recipe.lobe);
    object.read("term", recipe.term);
    if (const auto known = lobeFormNamed(recipe.lobe); !known)
        object.fail("picture.lobe: " + known.error().message);
    object.readNamed("shows", shownNames, recipe.shown);
    object.read("divider", recipe.divider, 0.0, 1.0);
    object.read("holes", recipe.holes);
    object.finish();
}

} // namespace

std::string_view nameOf(VariantView shown)
{
    return shownNames[static_cast<std::size_t>(shown)].name;
}

Notes keptNotes(const Scene& scene, const PictureRecipe& recipe, const std::string& folder)
{
    const Json json{{"schema", pictureSchema},     {"version", pictureVersion},
                    {"program", programVersion()}, {"folder", wholePath(folder)},
                    {"picture", written(recipe)},  {"scene", sceneJson(scene, {folder, {}, true})}};
    return {{"Software", "Reflectance Explorer " + std::string(programVersion())}, {noteKey, jsonText(json)}};
}

Result<KeptPicture> parseKept(std::string_view text, const std::string& file, const std::string& folder)
{
    const auto json = parsedJson(text, "a session in JSON", file);
    if (!json)
        return json.error();
    KeptPicture kept{defaultScene(), {}, {}};
    ScenePaths paths{wholePath(folder)};
    std::optional<std::string> problem;
    ObjectReader object(*json, "session", problem);
    object.readVersion(pictureSchema, pictureVersion);
    object.read("program", kept.program);
    object.read("folder", paths.folderBefore);
    object.readObject("picture", [&](ObjectReader part) { readRecipe(part, kept.recipe); });
    object.readObject("scene", [&](ObjectReader part) { readScene(part, kept.scene, paths); });
    object.finish();
    if (problem)
        return Error{*problem, file};
    return kept;
}

Result<KeptPicture> keptIn(std::string_view picture, const std::string& file)
{
    const auto notes = decodedNotes(picture, file);
    if (!notes)
        return notes.error();
    const std::string* text = findNote(*notes, noteKey);
    if (!text)
        return Error{"this picture carries no session; pictures that this program saved since version 0.1 do", file};
    return parseKept(*text, file, fs::path(file).parent_path().string());
}

Result<KeptPicture> loadKept(const std::string& path)
{
    const auto bytes = readWholeFile(path);
    return bytes ? keptIn(*bytes, path) : Result<KeptPicture>(bytes.error());
}

bool carriesSession(std::string_view picture)
{
    const auto notes = decodedNotes(picture, {});
    return notes && findNote(*notes, noteKey);
}

} // namespace reflectance
