#include "app/explorer/probe_study.h"

#include "core/math/angle.h"
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

} // namespace

std::optional<ProbePlace> placeAt(const Scene& scene, Cursor cursor, ViewSize size)
{
    const auto point = pointAt(*scene.mesh, scene.camera, cursor.x, cursor.y, size.width, size.height);
    if (!point)
        return std::nullopt;
    return ProbePlace{scene.mesh, *point, scene.camera};
}

ProbedPoint pointIn(const ProbePlace& place, const Camera& camera, ViewSize size)
{
    ProbedPoint point = place.point;
    if (camera == place.camera && size == ViewSize{point.width, point.height})
        return point;
    const Vec3d image = projected(camera, point.P, size.width, size.height);
    const bool ahead = image.z > 0.0;
    point.x = ahead ? image.x : -1.0;
    point.y = ahead ? image.y : -1.0;
    point.width = size.width;
    point.height = size.height;
    return point;
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

const ProbePlace* ProbeStudy::place() const
{
    if (picked)
        return *picked < pins.size() ? &pins[*picked] : nullptr;
    return loose ? &*loose : nullptr;
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

void ProbeStudy::pin()
{
    if (!loose || pins.size() >= mostPins)
        return;
    pins.push_back(*std::move(loose));
    loose.reset();
    picked = pins.size() - 1;
    ++changes;
}

void ProbeStudy::remove()
{
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

std::optional<std::size_t> pinAt(const ProbeStudy& study, const Scene& scene, ViewSize size, Cursor cursor,
                                 double reach)
{
    std::optional<std::size_t> nearest;
    double least = reach;
    for (std::size_t i = 0; i < study.pins.size(); ++i) {
        if (study.pins[i].mesh.lock() != scene.mesh)
            continue;
        const ProbedPoint point = pointIn(study.pins[i], scene.camera, size);
        if (const double distance = std::hypot(point.x - cursor.x, point.y - cursor.y); distance <= least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

std::vector<Probe> listed(const ProbeStudy& study)
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
    for (std::size_t i = 0; i < study.foundPins.size(); ++i)
        if (study.foundPins[i])
            add(*study.foundPins[i], std::to_string(i + 1));
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
