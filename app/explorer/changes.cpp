#include "app/explorer/changes.h"

#include "core/base/text.h"

#include <algorithm>
#include <vector>

namespace reflectance::explorer {
namespace {

std::string labelOf(const std::string& parameter)
{
    for (const Model& model : catalogue())
        if (const Parameter* found = model.text.find(parameter))
            return found->label;
    return parameter;
}

/// The names whose numbers differ.
std::vector<std::string> changedValues(const ParameterValues& a, const ParameterValues& b)
{
    std::vector<std::string> names;
    for (const auto& [name, numbers] : a)
        if (const auto other = b.find(name); other == b.end() || other->second != numbers)
            names.push_back(name);
    for (const auto& [name, numbers] : b)
        if (!a.contains(name))
            names.push_back(name);
    return names;
}

std::string nameOf(const Surface& before, const Surface& after)
{
    if (before.model != after.model)
        return "Model " + modelOf(after).text.name;
    if (before.rungs != after.rungs)
        return after.rungs.empty() ? "No rung" : "Rungs " + joined(after.rungs, " + ");
    const std::vector<std::string> names = changedValues(before.values, after.values);
    if (names.size() == 1)
        return labelOf(names.front());
    if (before.tableFile != after.tableFile || before.table != after.table)
        return "Measured table";
    return names.empty() ? "Convention of K" : "Parameters";
}

std::string nameOf(const Light& before, const Light& after)
{
    if (before.on != after.on)
        return (after.on ? "Switch on " : "Switch off ") + after.name;
    if (before.kind != after.kind)
        return "Kind of " + after.name;
    if (before.direction != after.direction || before.position != after.position)
        return "Move " + after.name;
    if (before.intensity != after.intensity)
        return "Intensity of " + after.name;
    return before.angularRadius != after.angularRadius ? "Size of " + after.name : "Rename " + before.name;
}

std::string nameOf(const std::vector<Light>& before, const std::vector<Light>& after)
{
    if (before.size() < after.size())
        return "Add a light";
    if (before.size() > after.size())
        return "Remove a light";
    std::size_t changed = 0, last = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
        if (before[i] != after[i]) {
            ++changed;
            last = i;
        }
    return changed == 1 ? nameOf(before[last], after[last]) : "Lights";
}

std::string nameOf(const std::vector<KeptSurface>& before, const std::vector<KeptSurface>& after)
{
    if (before.size() < after.size())
        return "Keep " + after.back().name;
    if (before.size() > after.size())
        return "Remove a variant";
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (before[i].name != after[i].name)
            return "Rename " + before[i].name;
        if (before[i].surface != after[i].surface)
            return "Renew " + after[i].name;
    }
    return "Variants";
}

std::string nameOf(const std::vector<Pin>& before, const std::vector<Pin>& after)
{
    if (before.size() < after.size())
        return "Pin " + after.back().name;
    if (before.size() > after.size())
        return "Remove a pin";
    for (std::size_t i = 0; i < after.size(); ++i)
        if (before[i].name != after[i].name)
            return "Rename pin " + before[i].name;
    return "Pins";
}

std::string nameOf(CompareMode mode)
{
    constexpr const char* names[] = {"Side by side", "Wipe", "Flip", "Difference"};
    return names[static_cast<int>(mode)];
}

std::string nameOf(const Camera& before, const Camera& after)
{
    if (before.fieldOfView != after.fieldOfView)
        return "Field of view";
    if (isZoom(before, after))
        return "Zoom";
    return before.target != after.target ? "Move the camera" : "Orbit";
}

/// What differs, part by part.
std::vector<std::string> partsOf(const Scene& a, const Scene& b)
{
    std::vector<std::string> parts;
    const auto note = [&](bool differs, auto name) {
        if (differs)
            parts.push_back(name());
    };
    note(a.mesh != b.mesh || a.meshFile != b.meshFile,
         [&] { return "Open " + (b.mesh ? b.mesh->name : std::string("a mesh")); });
    note(a.mesh == b.mesh && a.recomputeNormals != b.recomputeNormals, [] { return std::string("Smooth normals"); });
    note(a.surface != b.surface, [&] { return nameOf(a.surface, b.surface); });
    note(a.other && b.other && *a.other != *b.other, [&] { return "B: " + nameOf(*a.other, *b.other); });
    note(a.other.has_value() != b.other.has_value(), [] { return std::string("Compare"); });
    note(a.variants != b.variants, [&] { return nameOf(a.variants, b.variants); });
    note(a.pins != b.pins, [&] { return nameOf(a.pins, b.pins); });
    note(a.lights != b.lights, [&] { return nameOf(a.lights, b.lights); });
    note(a.environment != b.environment, [] { return std::string("Environment"); });
    note(a.background != b.background, [] { return std::string("Background"); });
    note(a.sensor != b.sensor,
         [&] { return std::string(a.sensor.exposure != b.sensor.exposure ? "Exposure" : "Sensor"); });
    note(a.camera != b.camera, [&] { return nameOf(a.camera, b.camera); });
    return parts;
}

std::string nameOfCase(const Moment& before, const Moment& after)
{
    return after.putAside && after.putAside != before.putAside ? after.putAside->title : "Back to your scene";
}

} // namespace

std::string nameOfChange(const Moment& before, const Moment& after)
{
    if (before.putAside != after.putAside)
        return nameOfCase(before, after);
    if (before.beforeClay.has_value() != after.beforeClay.has_value())
        return after.beforeClay ? "Clay" : "Put clay away";
    const Scene &a = before.scene, &b = after.scene;
    if (a.surface != b.surface && a.other && b.other && a.surface == *b.other && *a.other == b.surface)
        return "Swap A and B";
    std::vector<std::string> parts = partsOf(a, b);
    // A mesh that is opened is framed, a comparison that begins copies A: one thing to whoever did it.
    if (parts.size() > 2)
        return "Scene";
    if (before.comparing != after.comparing)
        return after.comparing ? "Compare" : "End the comparison";
    if (parts.empty() && before.mode != after.mode)
        return nameOf(after.mode);
    return parts.empty() ? "Change" : parts.front();
}

bool onlyCameraDiffers(const Moment& a, const Moment& b)
{
    Moment moved = a;
    moved.scene.camera = b.scene.camera;
    return a != b && moved == b;
}

bool onlySmoothingDiffers(const Moment& a, const Moment& b)
{
    Moment smoothed = a;
    smoothed.scene.recomputeNormals = b.scene.recomputeNormals;
    return a != b && smoothed == b;
}

bool isZoom(const Camera& a, const Camera& b)
{
    // Directions of eyes that were moved along a line differ by a few roundings.
    constexpr double same = 1.0 - 1e-12;
    return a.target == b.target && a.up == b.up && a.fieldOfView == b.fieldOfView &&
           dot(normalized(a.eye - a.target), normalized(b.eye - b.target)) > same;
}

} // namespace reflectance::explorer
