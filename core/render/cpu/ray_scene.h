// The mesh as Embree keeps it. It answers one question: which triangle does a ray meet first?
#pragma once

#include "core/geometry/mesh.h"

#include <array>
#include <cstdint>
#include <memory>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace reflectance {

/// Eight pieces of rays, each with an origin of its own. Floats serve them well where the mesh is about as large as 1.
struct SegmentPacket {
    std::array<Vec3d, 8> origins, directions; ///< unit directions
    std::array<double, 8> reach{};            ///< how far from the origin is looked
    std::array<bool, 8> active{};             ///< false: not to be traced
};

class RayScene {
public:
    static constexpr std::uint32_t nothing = 0xFFFFFFFF;

    /// How Embree's tree is made: for many rays, or in a quarter of the time for few, which then take a tenth longer. They meet
    /// the same.
    enum class Tree { ForMany, ForFew };
    explicit RayScene(std::shared_ptr<const Mesh> mesh, Tree tree = Tree::ForMany);

    [[nodiscard]] const Mesh& mesh() const { return *mesh_; }

    [[nodiscard]] double radius() const { return radius_; } ///< of a sphere about the origin that holds the mesh
    [[nodiscard]] RTCSceneTy* embree() const { return scene_.get(); }
    /// How many rays this processor traces together: 16 or 8.
    [[nodiscard]] int packetSize() const { return packetSize_; }

    /// The first triangle that each ray of the packet meets, or `nothing`.
    [[nodiscard]] std::array<std::uint32_t, 8> firstTriangles(const SegmentPacket& packet) const;

private:
    struct Release {
        void operator()(RTCDeviceTy* device) const;
        void operator()(RTCSceneTy* scene) const;
    };

    std::shared_ptr<const Mesh> mesh_;
    double radius_ = 0.0;
    std::unique_ptr<RTCDeviceTy, Release> device_;
    int packetSize_ = 8;
    std::unique_ptr<RTCSceneTy, Release> scene_;
};

} // namespace reflectance
