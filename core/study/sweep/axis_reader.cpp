#include "core/study/sweep/axis_reader.h"

#include "core/base/text.h"
#include "core/reflectance/catalogue.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

using Json = nlohmann::ordered_json;

/// More values of one axis are a mistake of the study, and would fill the memory before the first cell.
constexpr int mostSteps = 1'000'000;

enum class Scale { Linear, Log };
constexpr NamedValue<Scale> scales[] = {{"linear", Scale::Linear}, {"log", Scale::Log}};

constexpr std::pair<std::string_view, const char*> shortNames[] = {{"model", "/surface/model"},
                                                                   {"library", "/surface/library"},
                                                                   {"table", "/surface/file"},
                                                                   {"exposure", "/sensor/exposure"},
                                                                   {"mesh", "/mesh"},
                                                                   {"lights", "/lights"},
                                                                   {"camera", "/camera"},
                                                                   {"environment", "/environment"},
                                                                   {"background", "/background"}};

constexpr std::pair<std::string_view, AxisKind> otherKinds[] = {{"view", AxisKind::View},
                                                                {"size", AxisKind::Size},
                                                                {"samples", AxisKind::Samples},
                                                                {"renderer", AxisKind::Renderer}};

bool isParameter(const std::string& name)
{
    return std::any_of(catalogue().begin(), catalogue().end(),
                       [&](const Model& model) { return model.text.find(name) != nullptr; });
}

double between(double from, double to, int step, int steps, Scale scale)
{
    if (step == 0 || steps == 1)
        return from;
    if (step == steps - 1) // exactly, whatever the formula rounds to
        return to;
    const double t = static_cast<double>(step) / (steps - 1);
    return scale == Scale::Log ? from * std::pow(to / from, t) : from + t * (to - from);
}

void readRange(ObjectReader& object, StudyAxis& axis)
{
    double from = 0.0, to = 0.0;
    int steps = 0;
    Scale scale = Scale::Linear;
    object.read("from", from);
    object.read("to", to);
    object.read("steps", steps, 1, mostSteps);
    object.readNamed("scale", scales, scale);
    if (steps == 0 || !object.find("from") || !object.find("to"))
        return object.fail("axis '" + axis.name + "' needs values, or from, to and steps");
    if (scale == Scale::Log && !(from * to > 0.0))
        return object.fail("axis '" + axis.name + "' is logarithmic, so from and to must not be 0 and have one sign");
    for (int i = 0; i < steps; ++i)
        axis.values.push_back(Json(between(from, to, i, steps, scale)).dump());
}

bool isPair(const Json& value)
{
    return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

/// A whole number within 1 .. most.
bool isWhole(const Json& value, double most)
{
    return value.is_number_integer() && value.get<double>() >= 1.0 && value.get<double>() <= most;
}

bool isRenderer(const Json& value)
{
    return value.is_string() && std::any_of(std::begin(cellRenderers), std::end(cellRenderers),
                                            [&](const auto& named) { return named.name == value.get<std::string>(); });
}

/// What a value of this kind must be; empty if it is.
std::string complaint(AxisKind kind, const Json& value)
{
    if (kind == AxisKind::View)
        return isPair(value) ? "" : "a view is [azimuth, elevation] in degrees";
    if (kind == AxisKind::Renderer)
        return isRenderer(value) ? "" : "a renderer is double, float, simd, glsl or vertex";
    if (kind == AxisKind::Samples)
        return isWhole(value, 64) && checkedSettings(1, 1, value.get<int>())
                   ? ""
                   : "samples are 1, 4, 9, 16, 25, 36, 49 or 64";
    if (kind == AxisKind::Size)
        return isPair(value) && isWhole(value[0], 16384) && isWhole(value[1], 16384)
                   ? ""
                   : "a size is [width, height] in pixels, 1 .. 16384";
    return "";
}

/// A place of the scene file, below which anything may stand that readers know of.
Result<std::string> pointerOf(const Json& base, const std::string& name)
{
    for (const auto& [known, pointer] : shortNames)
        if (known == name)
            return std::string(pointer);
    if (isParameter(name))
        return "/surface/parameters/" + name;
    std::string pointer = "/" + name;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    if (name.find('~') == std::string::npos && base.contains(Json::json_pointer(pointer)))
        return pointer;
    std::vector<std::string> names;
    for (const auto& [known, kind] : otherKinds)
        names.emplace_back(known);
    for (const auto& [known, place] : shortNames)
        names.emplace_back(known);
    for (const Model& model : catalogue())
        for (const Parameter& parameter : model.text.parameters)
            names.push_back(parameter.name);
    return Error{"axis '" + name +
                 "' is neither a parameter nor a place of the scene file (lights.0.intensity); did you mean '" +
                 nearestName(name, names) + "'?"};
}

} // namespace

void readAxis(ObjectReader object, StudyAxis& axis)
{
    object.read("axis", axis.name);
    if (axis.name.empty())
        return object.fail("an axis has no name; write { \"axis\": \"model\", \"values\": [...] }");
    const Json* values = object.find("values");
    if (!values)
        readRange(object, axis);
    else if (!values->is_array() || values->empty())
        object.fail("axis '" + axis.name + "' has no values, so the study has no cells; list some");
    else
        for (const Json& value : *values)
            axis.values.push_back(value.dump());
    axis.labels = axis.values;
    if (const Json* names = object.find("names")) {
        const auto isName = [](const Json& name) { return name.is_string() && !name.get<std::string>().empty(); };
        if (!names->is_array() || names->size() != axis.values.size() ||
            !std::all_of(names->begin(), names->end(), isName))
            object.fail("axis '" + axis.name + "' must have as many names, in quotes, as values");
        else
            axis.labels = names->get<std::vector<std::string>>();
    } else {
        for (std::string& label : axis.labels) // a text without its quotes
            if (label.starts_with('"'))
                label = Json::parse(label).get<std::string>();
    }
    object.finish();
}

Result<void> placeAxis(const nlohmann::ordered_json& base, StudyAxis& axis)
{
    for (const auto& [name, kind] : otherKinds)
        if (name == axis.name)
            axis.kind = kind;
    if (axis.kind == AxisKind::Scene) {
        const auto pointer = pointerOf(base, axis.name);
        if (!pointer)
            return pointer.error();
        axis.pointer = *pointer;
    }
    for (const std::string& value : axis.values)
        if (const std::string wrong = complaint(axis.kind, Json::parse(value)); !wrong.empty())
            return Error{"axis '" + axis.name + "': " + value + " will not do; " + wrong};
    for (const std::string& label : axis.labels)
        if (std::any_of(label.begin(), label.end(), [](unsigned char c) { return c < 0x20; }))
            return Error{"axis '" + axis.name +
                         "': a name holds a line end or another control character; leave it out"};
    return {};
}

} // namespace reflectance
