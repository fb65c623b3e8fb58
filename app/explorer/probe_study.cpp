#include "app/explorer/probe_study.h"

#include "core/math/angle.h"
#include "core/render/cpu/surface_point.h"
#include "core/scene/names.h"
#include "core/study/lens/thinned.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {
namespace {

/// Scene units that a pixel spans at a distance from the eye.
double footprint(const Camera& camera, double distance, int height)
{
    return 2.0 * std::tan(radians(0.5 * camera.fieldOfView)) * distance / height;
}

/// Whether one of a pixel's samples lies where the point does: within the pixel's width on the surface, twice for its corners.
bool isAmong(const ViewSamples& samples, const ProbedPoint& point, const Camera& camera)
{
    const Vec3d toEye = camera.eye - point.P;
    const double distance = length(toEye);
    const double slant = std::max(0.05, std::fabs(dot(point.N, toEye)) / distance);
    const double reach = 2.0 * footprint(camera, distance, point.height) / slant;
    for (std::size_t i = 0; i < samples.count(); ++i)
        if (samples.triangle[i] == point.triangle ||
            length(Vec3d(samples.Px[i], samples.Py[i], samples.Pz[i]) - point.P) <= reach)
            return true;
    return false;
}

/// Where the picture shows a point; at -1 where it lies behind the eye.
ProbedPoint seenBy(const Camera& camera, ViewSize size, ProbedPoint point)
{
    const Vec3d image = projected(camera, point.P, size.width, size.height);
    const bool ahead = image.z > 0.0;
    point.x = ahead ? image.x : -1.0;
    point.y = ahead ? image.y : -1.0;
    point.width = size.width;
    point.height = size.height;
    return point;
}

std::string firstFreeNumber(const std::vector<Pin>& pins)
{
    int number = 1;
    while (nameIsTaken(pins, std::to_string(number)))
        ++number;
    return std::to_string(number);
}

} // namespace

std::optional<ProbePlace> placeAt(const Scene& scene, Cursor cursor, ViewSize size)
{
    const auto point = pointAt(scene.mesh, scene.camera, cursor.x, cursor.y, size.width, size.height);
    if (!point)
        return std::nullopt;
    return ProbePlace{scene.mesh, *point, scene.camera};
}

ProbedPoint pointIn(const ProbePlace& place, const Camera& camera, ViewSize size)
{
    const ProbedPoint& point = place.point;
    if (camera == place.camera && size == ViewSize{point.width, point.height})
        return point;
    return seenBy(camera, size, point);
}

std::optional<ProbedPoint> pointIn(const Pin& pin, const Scene& scene, ViewSize size)
{
    if (pin.meshFile != scene.meshFile || !scene.mesh || pin.triangle >= scene.mesh->triangles.size())
        return std::nullopt;
    ProbedPoint point;
    point.P = pin.P;
    point.N = surfacePoint(*scene.mesh, pin.triangle, scene.camera.eye, normalized(pin.P - scene.camera.eye)).N;
    point.triangle = pin.triangle;
    return seenBy(scene.camera, size, point);
}

std::optional<ProbedPixel> pixelOf(const ViewSamples& samples, const Image& drawn, const Scene& scene,
                                   const ProbedPoint& point)
{
    const bool inside = point.x >= 0.0 && point.y >= 0.0 && point.x < drawn.width && point.y < drawn.height;
    if (!inside || point.width != drawn.width || point.height != drawn.height)
        return std::nullopt;
    const int x = static_cast<int>(point.x), y = static_cast<int>(point.y);
    const ViewSamples few = crossings(samples, {x}, {y});
    Image one(1, 1);
    std::copy_n(drawn.at(x, y), 3, one.at(0, 0));
    ProbedPixel pixel{isAmong(few, point, scene.camera), std::nullopt};
    const Progress unwatched;
    if (const auto check = checkGl(few, one, scene, 1, unwatched); check && check->pixels == 1)
        pixel.drawn = check->worst;
    return pixel;
}

bool ProbeStudy::looks(const Scene& scene) const
{
    return picked ? *picked < scene.pins.size() : loose.has_value();
}

const FoundProbe* ProbeStudy::found() const
{
    if (!picked)
        return loose && foundLoose ? &*foundLoose : nullptr;
    return *picked < foundPins.size() && foundPins[*picked] ? &*foundPins[*picked] : nullptr;
}

void ProbeStudy::probe(std::optional<ProbePlace> place)
{
    loose = std::move(place);
    picked.reset();
    ++changes;
}

void ProbeStudy::pin(Scene& scene)
{
    if (!loose || scene.pins.size() >= mostPins)
        return;
    scene.pins.push_back({firstFreeNumber(scene.pins), scene.meshFile, loose->point.P, loose->point.triangle});
    loose.reset();
    picked = scene.pins.size() - 1;
    ++changes;
}

void ProbeStudy::remove(Scene& scene)
{
    auto& pins = scene.pins;
    if (!picked)
        loose.reset();
    else if (*picked < pins.size())
        pins.erase(pins.begin() + static_cast<std::ptrdiff_t>(*picked));
    if (picked && *picked >= pins.size())
        picked = pins.empty() ? std::optional<std::size_t>() : pins.size() - 1;
    ++changes;
}

void ProbeStudy::pick(std::size_t pin)
{
    picked = pin;
    ++changes;
}

std::optional<std::size_t> pinAt(const Scene& scene, ViewSize size, Cursor cursor, double reach)
{
    std::optional<std::size_t> nearest;
    double least = reach;
    for (std::size_t i = 0; i < scene.pins.size(); ++i) {
        const auto point = pointIn(scene.pins[i], scene, size);
        if (!point)
            continue;
        if (const double distance = std::hypot(point->x - cursor.x, point->y - cursor.y); distance <= least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

std::vector<Probe> listed(const ProbeStudy& study, const Scene& scene)
{
    std::vector<Probe> all;
    const auto add = [&all](const FoundProbe& found, const std::string& name) {
        all.push_back(found.a);
        all.back().name = found.b ? name + " A" : name;
        if (!found.b)
            return;
        all.push_back(*found.b);
        all.back().name = name + " B";
    };
    for (std::size_t i = 0; i < std::min(study.foundPins.size(), scene.pins.size()); ++i)
        if (study.foundPins[i])
            add(*study.foundPins[i], scene.pins[i].name);
    if (study.loose && study.foundLoose)
        add(*study.foundLoose, "here");
    return all;
}

std::string textOf(const FoundProbe& found)
{
    if (!found.b)
        return probeText(found.a);
    return "A\n" + probeText(found.a) + "\nB\n" + probeText(*found.b);
}

} // namespace reflectance::explorer
