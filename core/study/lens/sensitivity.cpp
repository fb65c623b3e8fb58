#include "core/study/lens/sensitivity.h"

#include "core/reflectance/lists.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/study/lens/thinned.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace reflectance {
namespace {

constexpr double step = 16.0 * 0x1p-24;

std::vector<Vec3d> valuesOfSamples(const ViewSamples& samples, const Scene& scene)
{
    const Image image = shadeSamples(samples, scene, Precision::Double);
    std::vector<Vec3d> values(samples.count());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = {image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2]};
    return values;
}

Vec3d apart(const Vec3d& a, const Vec3d& b)
{
    return {std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)};
}

Vec3d larger(const Vec3d& a, const Vec3d& b)
{
    return {std::fmax(a.x, b.x), std::fmax(a.y, b.y), std::fmax(a.z, b.z)};
}

/// Adds what one number changes: `moved(+1)` and `moved(-1)` are the values with it a step up and a step down.
void addChange(const std::vector<Vec3d>& rest, const std::function<std::vector<Vec3d>(double way)>& moved,
               std::vector<Vec3d>& slopes)
{
    const std::vector<Vec3d> up = moved(1.0);
    const std::vector<Vec3d> down = moved(-1.0);
    for (std::size_t i = 0; i < rest.size(); ++i)
        slopes[i] += larger(apart(up[i], rest[i]), apart(down[i], rest[i])) / step;
}

void moveNormals(const ViewSamples& samples, const Scene& scene, Sensitivity& found)
{
    for (std::vector<double> ViewSamples::*column : {&ViewSamples::Nx, &ViewSamples::Ny, &ViewSamples::Nz})
        addChange(
            found.value,
            [&](double way) {
                ViewSamples moved = samples;
                for (double& component : moved.*column)
                    component += way * step;
                return valuesOfSamples(moved, scene);
            },
            found.of[static_cast<int>(Input::Normal)]);
}

/// V follows from the eye and P: what is lost there are units of the longer of the two lengths. It moves P, which takes
/// point lights along.
void moveViewers(const ViewSamples& samples, const Scene& scene, Sensitivity& found)
{
    const double eye = length(samples.eye);
    for (std::vector<double> ViewSamples::*column : {&ViewSamples::Px, &ViewSamples::Py, &ViewSamples::Pz})
        addChange(
            found.value,
            [&](double way) {
                ViewSamples moved = samples;
                for (std::size_t i = 0; i < samples.count(); ++i) {
                    const Vec3d P{samples.Px[i], samples.Py[i], samples.Pz[i]};
                    (moved.*column)[i] += way * step * std::fmax(eye, length(samples.eye - P));
                }
                return valuesOfSamples(moved, scene);
            },
            found.of[static_cast<int>(Input::Viewer)]);
}

using ChangeLight = std::function<void(Light& light, double way)>;

std::vector<ChangeLight> changesOfLights()
{
    std::vector<ChangeLight> changes;
    for (double Vec3d::*component : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
        changes.emplace_back([component](Light& light, double way) {
            Vec3d& place = light.kind == LightKind::Point ? light.position : light.direction;
            place.*component += way * step * length(place);
        });
        changes.emplace_back([component](Light& light, double way) { light.intensity.*component *= 1.0 + way * step; });
    }
    changes.emplace_back([](Light& light, double way) { light.angularRadius *= 1.0 + way * step; });
    return changes;
}

/// One light at a time, for they round apart.
void moveLights(const ViewSamples& samples, const Scene& scene, Sensitivity& found)
{
    for (const Light& light : shiningLights(scene)) {
        Scene alone = scene;
        alone.environment.kind = EnvironmentKind::None;
        alone.lights = {light};
        const std::vector<Vec3d> rest = valuesOfSamples(samples, alone);
        for (const ChangeLight& change : changesOfLights())
            addChange(
                rest,
                [&](double way) {
                    Scene moved = alone;
                    change(moved.lights.front(), way);
                    return valuesOfSamples(samples, moved);
                },
                found.of[static_cast<int>(Input::Light)]);
    }
}

void moveParameters(const ViewSamples& samples, const Scene& scene, Sensitivity& found)
{
    const ModelText& model = modelOf(scene).text;
    const ParameterValues values = valuesByName(model, valuesOf(scene));
    for (const Parameter& parameter : model.parameters) {
        if (parameter.kind == ParameterKind::Choice) // it knows no in-between
            continue;
        const std::vector<double>& numbers = values.at(parameter.name);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (numbers[i] == 0.0)
                continue;
            addChange(
                found.value,
                [&](double way) {
                    Scene moved = scene;
                    std::vector<double>& changed = moved.surface.values[parameter.name];
                    changed = numbers;
                    changed[i] *= 1.0 + way * step;
                    return valuesOfSamples(samples, moved);
                },
                found.of[static_cast<int>(Input::Parameter)]);
        }
    }
}

} // namespace

Vec3d Sensitivity::all(std::size_t sample) const
{
    return of[0][sample] + of[1][sample] + of[2][sample] + of[3][sample];
}

Sensitivity sensitivityOf(const ViewSamples& samples, const Scene& scene)
{
    const ViewSamples apiece = eachAPixel(samples);
    Sensitivity found;
    found.value = valuesOfSamples(apiece, scene);
    for (std::vector<Vec3d>& slopes : found.of)
        slopes.resize(apiece.count());
    moveNormals(apiece, scene, found);
    moveViewers(apiece, scene, found);
    moveLights(apiece, scene, found);
    moveParameters(apiece, scene, found);
    return found;
}

} // namespace reflectance
