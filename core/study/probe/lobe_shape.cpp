#include "core/study/probe/lobe_shape.h"

#include "core/math/angle.h"
#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

constexpr int meridianStep = 30, ringStep = 15, fineStep = 3, turn = 360, horizon = 90;
/// At the horizon itself some formulas jump, and some (Ward's) have no bound.
constexpr double farthestTheta = 89.5;
/// A highlight of n = 1000 falls to its half within 2 degrees.
constexpr double finest = 0.1, fineReach = 6.0;

/// N, the side of L, and what stands on both.
struct Frame {
    Vec3d N, towardsL, across;

    /// In degrees: from N, and about it from L's side.
    [[nodiscard]] Vec3d direction(double theta, double phi) const
    {
        const double t = radians(theta), p = radians(phi);
        return std::cos(t) * N + std::sin(t) * (std::cos(p) * towardsL + std::sin(p) * across);
    }
};

Frame frameAt(const Vec3d& N, const Vec3d& L)
{
    Vec3d side = L - dot(N, L) * N;
    if (length(side) < 1e-9) // the light is overhead: any plane is that of incidence
        side = std::fabs(N.x) < 0.5 ? cross(N, Vec3d(1.0, 0.0, 0.0)) : cross(N, Vec3d(0.0, 1.0, 0.0));
    side = normalized(side);
    return {N, side, cross(N, side)};
}

/// Degrees from N in the plane of incidence, R's side negative.
std::vector<double> planeAngles(double thetaOfL)
{
    std::vector<double> angles;
    for (int i = 1 - horizon; i < horizon; ++i)
        angles.push_back(i);
    angles.push_back(-farthestTheta);
    angles.push_back(farthestTheta);
    for (double off = -fineReach; off <= fineReach; off += finest)
        if (const double angle = off - thetaOfL; std::fabs(angle) < farthestTheta)
            angles.push_back(angle);
    angles.push_back(-std::min(thetaOfL, farthestTheta));
    std::ranges::sort(angles);
    return angles;
}

} // namespace

LobeShape lobeShape(const Scene& scene, const Probe& probe, std::size_t light, double radius)
{
    LobeShape shape;
    const ProbedLight& probed = probe.lights[light];
    if (!(probed.cosine > 0.0))
        return shape;
    const Frame frame = frameAt(probe.point.N, probed.L);
    std::vector<std::vector<Vec3d>> lines;
    for (int phi = 0; phi < turn; phi += meridianStep) {
        auto& line = lines.emplace_back();
        for (int theta = 0; theta <= horizon; theta += fineStep)
            line.push_back(frame.direction(std::min<double>(theta, farthestTheta), phi));
    }
    for (int theta = ringStep; theta < horizon; theta += ringStep) {
        auto& line = lines.emplace_back();
        for (int phi = 0; phi <= turn; phi += 2 * fineStep)
            line.push_back(frame.direction(theta, phi));
    }
    auto& plane = lines.emplace_back();
    for (const double angle : planeAngles(degrees(std::acos(std::min(1.0, probed.cosine)))))
        plane.push_back(frame.direction(angle, 0.0));

    std::vector<Observation> rows;
    const Vec3d white{1.0, 1.0, 1.0};
    for (const auto& line : lines)
        for (const Vec3d& omega : line)
            rows.push_back({probe.point.N, omega, {{probed.L, white, scene.lights[probed.index].angularRadius}}});
    const std::vector<Vec3d> values =
        evaluate(modelOf(scene), valuesOf(scene), rows, Precision::Double, lookUpsIn(scene.surface.table.get()));
    std::vector<double> radii;
    for (const Vec3d& value : values) {
        const double mean = (value.x + value.y + value.z) / 3.0;
        radii.push_back(mean > 0.0 && std::isfinite(mean) ? mean : 0.0);
        shape.largest = std::max(shape.largest, radii.back());
    }
    if (shape.largest == 0.0)
        return shape;
    std::size_t next = 0;
    for (auto& line : lines)
        for (Vec3d& omega : line)
            omega = probe.point.P + (radius * radii[next++] / shape.largest) * omega;
    shape.inPlane = std::move(lines.back());
    lines.pop_back();
    shape.wires = std::move(lines);
    return shape;
}

} // namespace reflectance
