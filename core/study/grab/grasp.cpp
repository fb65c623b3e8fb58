// What lies under a cursor, and where a light's spot is seen.
#include "core/study/grab/spot_angle.h"
#include "core/study/grab/width.h"

#include <numbers>

namespace reflectance {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
/// A spot without an edge that the formula knows: as far as a hand would call it the spot.
constexpr double spotWithoutEdge = 12.0 * degree, smallestDisc = 2.0 * degree;

/// The point of the picture, and those one pixel beside and below it, on the same piece of the surface.
struct Neighbourhood {
    ProbedPoint here;
    std::optional<ProbedPoint> beside, below;
};

std::optional<ProbedPoint> neighbour(const Scene& scene, const ProbedPoint& here, double dx, double dy)
{
    for (const double sign : {1.0, -1.0}) {
        const auto there =
            pointAt(scene.mesh, scene.camera, here.x + sign * dx, here.y + sign * dy, here.width, here.height);
        // Across a silhouette the surface jumps; a slope there would mean nothing.
        if (there && length(there->P - here.P) < 0.1)
            return there;
    }
    return std::nullopt;
}

/// Change of a quantity per pixel; 0 where no neighbour tells.
template <class Quantity> double slope(const Neighbourhood& around, Quantity quantity)
{
    const double here = quantity(around.here);
    const double dx = around.beside ? quantity(*around.beside) - here : 0.0;
    const double dy = around.below ? quantity(*around.below) - here : 0.0;
    return std::hypot(dx, dy);
}

struct Wish {
    const Scene& scene;
    SpotKind kind;
    double reach;
    Vec3d eye;
    bool hasEdge; ///< a number of the model says how wide the spot is
};

double spotAngleAt(const Wish& wish, const Light& light, const ProbedPoint& point)
{
    return spotAngle(wish.kind, point.N, arrivalAt(light, point.P).L, normalized(wish.eye - point.P));
}

/// Of heights h of a spot: sqrt(-ln h) grows about as the angle to the peak does, so that its slope tells pixels.
double spread(double height)
{
    return std::sqrt(-std::log(std::clamp(height, 1e-12, 1.0)));
}

double spotSize(const Wish& wish, const Light& light)
{
    return modelOf(wish.scene).text.usesLightSize ? std::max(smallestDisc, light.angularRadius * degree)
                                                  : spotWithoutEdge;
}

std::optional<Grasp> graspOf(const Wish& wish, std::size_t index, const Neighbourhood& around)
{
    const Light& light = wish.scene.lights[index];
    const auto cosine = [&](const ProbedPoint& p) { return dot(p.N, arrivalAt(light, p.P).L); };
    const double NL = cosine(around.here);
    const auto angle = [&](const ProbedPoint& p) { return spotAngleAt(wish, light, p); };
    if (NL > 0.0) {
        const double fromPeak = angle(around.here), reach = wish.reach * slope(around, angle);
        if (wish.hasEdge) {
            const auto far = [&](const ProbedPoint& p) {
                return spread(spotHeight(wish.scene, light, p).value_or(0.0));
            };
            const double here = far(around.here), perPixel = slope(around, far),
                         off = std::fabs(here - spread(edgeHeight));
            // A spot that is smaller than the hand is taken at its middle.
            if (fromPeak > reach && off <= wish.reach * perPixel)
                return Grasp{Grip::Edge, index, perPixel > 0.0 ? off / perPixel : 0.0};
            if (here < spread(edgeHeight) || fromPeak <= reach)
                return Grasp{Grip::Spot, index, 0.0};
        } else if (fromPeak < spotSize(wish, light) || fromPeak <= reach) {
            return Grasp{Grip::Spot, index, 0.0};
        }
    }
    if (const double perPixel = slope(around, cosine); std::fabs(NL) <= wish.reach * perPixel)
        return Grasp{Grip::Terminator, index, perPixel > 0.0 ? std::fabs(NL) / perPixel : 0.0};
    return std::nullopt;
}

/// Edges first, then spots: an edge is thin. Among equals the brighter light.
double rank(const Grasp& grasp, const Light& light, const Vec3d& P)
{
    const Vec3d I = arrivalAt(light, P).I;
    const double brightness = I.x + I.y + I.z;
    constexpr double apart = 1e12; // more than any intensity
    return brightness + (grasp.grip == Grip::Edge ? 2.0 * apart : grasp.grip == Grip::Spot ? apart : 0.0);
}

struct Candidate {
    double angle = 0.0;
    Vec3d P;
};

/// The vertices nearest to the peak, nearest first: the spot is seen at one of them, if it is seen.
std::vector<Candidate> nearestVertices(const Scene& scene, const Light& light, SpotKind kind, std::size_t most)
{
    const Mesh& mesh = *scene.mesh;
    std::vector<Candidate> all;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3d& P = mesh.positions[i];
        const Vec3d V = normalized(scene.camera.eye - P), L = arrivalAt(light, P).L;
        const Vec3d N = dot(mesh.normals[i], V) < 0.0 ? -mesh.normals[i] : mesh.normals[i];
        if (dot(N, L) > 0.0)
            all.push_back({spotAngle(kind, N, L, V), P});
    }
    const std::size_t kept = std::min(most, all.size());
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end(),
                      [](const Candidate& a, const Candidate& b) { return a.angle < b.angle; });
    all.resize(kept);
    return all;
}

/// Downhill in the picture, from steps of 8 pixels to a quarter of one.
ProbedPoint atPeak(const Wish& wish, const Light& light, ProbedPoint best)
{
    for (double step = 8.0; step >= 0.25; step /= 2.0)
        for (bool better = true; better;) {
            better = false;
            for (const auto& [dx, dy] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
                const auto next =
                    pointAt(wish.scene.mesh, wish.scene.camera, best.x + dx, best.y + dy, best.width, best.height);
                if (next && spotAngleAt(wish, light, *next) < spotAngleAt(wish, light, best)) {
                    best = *next;
                    better = true;
                }
            }
        }
    return best;
}

} // namespace

std::optional<Grasp> graspAt(const Scene& scene, const ProbedPoint& point, double reach)
{
    const Wish wish{scene, spotKindOf(scene), reach, scene.camera.eye, spotWidthOf(scene).has_value()};
    const Neighbourhood around{point, neighbour(scene, point, 1.0, 0.0), neighbour(scene, point, 0.0, 1.0)};
    std::optional<Grasp> best;
    double bestRank = 0.0;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (!scene.lights[i].on)
            continue;
        const auto grasp = graspOf(wish, i, around);
        const double its = grasp ? rank(*grasp, scene.lights[i], point.P) : 0.0;
        if (grasp && (!best || its > bestRank)) {
            best = grasp;
            bestRank = its;
        }
    }
    return best;
}

std::optional<ProbedPoint> spotIn(const Scene& scene, const Light& light, int width, int height)
{
    const Wish wish{scene, spotKindOf(scene), 0.0, scene.camera.eye, false};
    constexpr std::size_t mostVertices = 24;
    for (const Candidate& candidate : nearestVertices(scene, light, wish.kind, mostVertices)) {
        const Vec3d image = projected(scene.camera, candidate.P, width, height);
        if (!(image.z > 0.0) || image.x < 0.0 || image.y < 0.0 || image.x > width || image.y > height)
            continue;
        const auto seen = pointAt(scene.mesh, scene.camera, image.x, image.y, width, height);
        if (seen && length(seen->P - candidate.P) < 1e-3)
            return atPeak(wish, light, *seen);
    }
    return std::nullopt;
}

} // namespace reflectance
