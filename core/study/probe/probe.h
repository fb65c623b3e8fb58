// One point of the picture, stage by stage, in double: what light arrives, what the formula does with it term by term, and
// what the sensor makes of it.
#pragma once

#include "core/reflectance/walked/account.h"
#include "core/render/cpu/cpu_renderer.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reflectance {

/// Where a ray through the picture meets the object.
struct ProbedPoint {
    double x = 0.0, y = 0.0;   ///< in the picture, pixels from its upper left corner
    int width = 1, height = 1; ///< of the picture
    Vec3d P, N;                ///< as a sample has them (core/render/view_samples.h)
    std::uint32_t triangle = 0;
};

/// Nothing where the ray misses the object. Every triangle is tried, in double: a few milliseconds per million.
[[nodiscard]] std::optional<ProbedPoint> pointAt(const Mesh& mesh, const Camera& camera, double x, double y, int width,
                                                 int height);
/// The same point for a mesh that is looked at again: all but the triangles near the ray are left out. The first call for a
/// mesh takes some three times as long as trying every triangle.
[[nodiscard]] std::optional<ProbedPoint> pointAt(const std::shared_ptr<const Mesh>& mesh, const Camera& camera,
                                                 double x, double y, int width, int height);

struct ProbedTerm {
    std::string name;   ///< "diffuse"
    std::string source; ///< "cosine * (K * I)"
    Vec3d value;        ///< what the formula gives with this term alone
};

struct ProbedLight {
    std::size_t index = 0; ///< in the scene
    std::string name;
    LightKind kind = LightKind::Directional;
    double distance = 0.0;                   ///< of a point light, scene units
    Vec3d sent;                              ///< its intensity, as the sensor sees it on a perfect white
    Vec3d L, I;                              ///< as it arrives
    Vec3d R;                                 ///< L mirrored about N
    double cosine = 0.0, mirrorCosine = 0.0; ///< N.L, R.V
    Vec3d value;                             ///< what it adds
    walked::Account account;
    std::vector<ProbedTerm> terms; ///< where the formula is a sum
};

struct Probe {
    std::string name; ///< in a list of probes, "2 B"; empty: its number there
    ProbedPoint point;
    std::string model, formula; ///< for people
    std::string convention;     ///< of the numbers in K, in words; empty for a model without K
    Vec3d V;
    double distance = 0.0; ///< to the eye
    double NV = 0.0;
    std::vector<ProbedLight> lights;   ///< that shine, in the order in which they are added up
    std::optional<Vec3d> surroundings; ///< what the model sees of them
    Vec3d value;       ///< linear: what shadeSamples gives for a sample here, before it is rounded to float
    double gain = 1.0; ///< of the sensor, exposure included
    Vec3d exposed, encoded;
    std::array<std::uint8_t, 3> codes{};
    std::array<bool, 3> clipped{}; ///< above 1 or below 0 after exposure
};

/// The scene's surface (A; B's by variantB) at a point of its mesh. Stripes that show a table's holes are left out.
[[nodiscard]] Probe probeAt(const Scene& scene, const ProbedPoint& point);

/// For people: some thirty lines.
[[nodiscard]] std::string probeText(const Probe& probe);

/// One row per light of each probe, with a header; numbers read back to the same double.
[[nodiscard]] std::string probeCsv(const std::vector<Probe>& probes);

} // namespace reflectance
