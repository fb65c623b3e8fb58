#include "core/study/sweep/study.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/reflectance/catalogue.h"
#include "core/scene/scene_file.h"
#include "core/study/sweep/axis_reader.h"

#include <algorithm>
#include <filesystem>

namespace reflectance {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr int studyFormatVersion = 1;

/// The base scene written out whole, so that every place of it exists; "scene" is a file's name, or a scene's keys.
Result<std::string> baseScene(const Json* given, const std::string& file, const std::string& folder)
{
    Result<Scene> scene = defaultScene();
    if (given && given->is_string())
        scene = loadScene((fs::path(folder) / given->get<std::string>()).string());
    else if (given)
        scene = parseScene(given->dump(), file, folder);
    if (!scene)
        return scene.error();
    scene->other.reset(); // a cell is one surface
    return sceneText(*scene, folder);
}

/// Two axes that set the same place, or one inside the other's, whose value would be lost.
std::string contradiction(const std::vector<StudyAxis>& axes)
{
    const auto sets = [](const StudyAxis& axis) {
        return axis.kind == AxisKind::Scene  ? axis.pointer
               : axis.kind == AxisKind::View ? std::string("/camera")
                                             : axis.name;
    };
    for (std::size_t i = 0; i < axes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::string a = sets(axes[j]), b = sets(axes[i]);
            if (a == b || (b + "/").starts_with(a + "/") || (a + "/").starts_with(b + "/"))
                return "axes '" + axes[j].name + "' and '" + axes[i].name + "' contradict each other: both set " +
                       (a.size() > b.size() ? a : b) + "; leave one out";
        }
    return "";
}

const StudyAxis* axisAt(const Study& study, std::string_view pointer)
{
    const auto found = std::find_if(study.axes.begin(), study.axes.end(),
                                    [&](const StudyAxis& axis) { return axis.pointer == pointer; });
    return found == study.axes.end() ? nullptr : &*found;
}

/// A library surface brings its model and parameters, so axes of them come after it and not beside it.
std::string parameterWithoutModel(const Study& study, const Json& base)
{
    if (axisAt(study, "/surface/library"))
        return axisAt(study, "/surface/model")
                   ? "axes 'library' and 'model' contradict each other: a library surface has "
                     "its own model; leave one out"
                   : "";
    std::vector<std::string> models{base["surface"]["model"].get<std::string>()};
    if (const StudyAxis* axis = axisAt(study, "/surface/model"))
        models = axis->labels.empty() ? models : axis->values;
    for (const StudyAxis& axis : study.axes) {
        constexpr std::string_view place = "/surface/parameters/";
        if (!axis.pointer.starts_with(place))
            continue;
        const std::string name = axis.pointer.substr(place.size());
        const bool used = std::any_of(models.begin(), models.end(), [&](const std::string& text) {
            const Json id = text.starts_with('"') ? Json::parse(text) : Json(text);
            const auto model = id.is_string() ? findModel(id.get<std::string>()) : Result<const Model*>(Error{});
            return !model || (*model)->text.find(name) != nullptr;
        });
        if (!used)
            return "axis '" + axis.name + "' changes nothing: no model of the study has this parameter (" +
                   joined(models) + "); add a model that has it";
    }
    return "";
}

std::string tooMany(const std::vector<StudyAxis>& axes)
{
    std::uint64_t count = 1;
    for (const StudyAxis& axis : axes) {
        if (axis.values.size() > mostCells / count)
            return "the axes make more than 1e15 cells; take fewer values";
        count *= axis.values.size();
    }
    return "";
}

/// Keys that are no axes: how large, how finely and by what.
void readSettings(ObjectReader& object, Study& study)
{
    int samples = study.settings.samplesPerAxis * study.settings.samplesPerAxis;
    object.read("width", study.settings.width, 1, 16384);
    object.read("height", study.settings.height, 1, 16384);
    object.read("samples", samples, 1, 64);
    object.readNamed("renderer", cellRenderers, study.renderer);
    const auto checked = checkedSettings(study.settings.width, study.settings.height, samples);
    if (!checked)
        return object.fail(checked.error().message);
    study.settings = *checked;
}

Result<void> completed(Study& study)
{
    const Json base = Json::parse(study.scene);
    for (StudyAxis& axis : study.axes)
        if (auto placed = placeAxis(base, axis); !placed)
            return placed;
    for (const std::string& wrong :
         {contradiction(study.axes), parameterWithoutModel(study, base), tooMany(study.axes)})
        if (!wrong.empty())
            return Error{wrong};
    return {};
}

/// An object is merged into what stands there, anything else replaces it.
void put(const Json& value, const StudyAxis& axis, Json& scene)
{
    Json& place = scene[Json::json_pointer(axis.pointer)];
    if (axis.pointer == "/surface/library") // what the base scene says of the surface would win over the library
        scene["surface"] = Json{{"library", value}};
    else if (value.is_object() && place.is_object())
        place.merge_patch(value);
    else
        place = value;
}

CellRenderer rendererNamed(const std::string& name)
{
    for (const auto& named : cellRenderers)
        if (named.name == name)
            return named.value;
    return CellRenderer::Double;
}

void apply(const StudyAxis& axis, const Json& value, Json& scene, Cell& cell)
{
    switch (axis.kind) {
    case AxisKind::Scene:
        return put(value, axis, scene);
    case AxisKind::View:
        cell.orbit = {value[0].get<double>(), value[1].get<double>()};
        return;
    case AxisKind::Size:
        cell.settings.width = value[0].get<int>();
        cell.settings.height = value[1].get<int>();
        return;
    case AxisKind::Samples:
        cell.settings.samplesPerAxis = checkedSettings(1, 1, value.get<int>())->samplesPerAxis;
        return;
    case AxisKind::Renderer:
        cell.renderer = rendererNamed(value.get<std::string>());
    }
}

} // namespace

Result<Study> parseStudy(std::string_view text, const std::string& file, const std::string& folder)
{
    const auto json = parsedJson(text, "a JSON study", file);
    if (!json)
        return json.error();
    std::optional<std::string> problem;
    ObjectReader object(*json, "study", problem);
    Study study;
    study.folder = folder;
    int version = studyFormatVersion;
    object.read("reflectance_study", version, 1, studyFormatVersion);
    const Json* scene = json->is_object() ? object.find("scene") : nullptr;
    if (scene && !scene->is_string() && !scene->is_object())
        object.fail("study.scene must be the name of a scene file or an object with a scene's keys");
    readSettings(object, study);
    object.readList("axes", study.axes, readAxis);
    object.finish();
    if (!problem && study.axes.empty())
        problem = "the study has no axes, so there is nothing to sweep; 'render' makes a single picture";
    if (problem)
        return Error{*problem, file};
    auto base = baseScene(scene, file, folder);
    if (!base)
        return base.error();
    study.scene = *std::move(base);
    if (const auto whole = completed(study); !whole)
        return Error{whole.error().message, file};
    return study;
}

Result<Study> loadStudy(const std::string& path)
{
    const auto text = readWholeFile(path, std::uintmax_t{64} << 20U);
    if (!text)
        return text.error();
    return parseStudy(*text, path, fs::path(path).parent_path().string());
}

std::uint64_t cellCount(const Study& study)
{
    std::uint64_t count = 1;
    for (const StudyAxis& axis : study.axes)
        count *= axis.values.size();
    return count;
}

Cell cellAt(const Study& study, std::uint64_t index)
{
    Cell cell;
    cell.index = index;
    cell.settings = study.settings;
    cell.renderer = study.renderer;
    std::vector<std::size_t> chosen(study.axes.size());
    for (std::size_t i = study.axes.size(); i-- > 0;) {
        chosen[i] = static_cast<std::size_t>(index % study.axes[i].values.size());
        index /= study.axes[i].values.size();
    }
    Json scene = Json::parse(study.scene);
    const auto applyAll = [&](bool library) {
        for (std::size_t i = 0; i < study.axes.size(); ++i)
            if ((study.axes[i].pointer == "/surface/library") == library)
                apply(study.axes[i], Json::parse(study.axes[i].values[chosen[i]]), scene, cell);
    };
    applyAll(true); // first: it replaces the surface
    applyAll(false);
    for (std::size_t i = 0; i < study.axes.size(); ++i)
        if (hasColumn(study.axes[i]))
            cell.labels.push_back(study.axes[i].labels[chosen[i]]);
    cell.scene = scene.dump();
    return cell;
}

std::string_view nameOf(CellRenderer renderer)
{
    return cellRenderers[static_cast<int>(renderer)].name;
}

bool hasColumn(const StudyAxis& axis)
{
    return axis.kind == AxisKind::Scene || axis.kind == AxisKind::View;
}

} // namespace reflectance
