// The meshes that lie on the graphics card.
#pragma once

#include "core/render/gl/mesh_buffers.h"

#include <array>
#include <cstdint>
#include <memory>

namespace reflectance {

/// The mesh in use and, where one of the two has at most a quarter of the other's triangles, the one before it: a big mesh
/// and its stand-in take turns without being uploaded again, and two big ones never lie there together.
class UploadedMeshes {
public:
    explicit UploadedMeshes(const Gl& gl) : gl_(&gl), slots_{Slot{nullptr, MeshBuffers(gl)}, {nullptr, MeshBuffers(gl)}}
    {
    }

    /// Its buffers, uploaded if they are not there. Refuses a mesh that is too large for this driver.
    [[nodiscard]] Result<const MeshBuffers*> buffersOf(const std::shared_ptr<const Mesh>& mesh);

    [[nodiscard]] std::uint64_t uploads() const { return uploads_; }
    [[nodiscard]] std::uint64_t uploadedBytes() const { return uploadedBytes_; }

private:
    struct Slot {
        std::shared_ptr<const Mesh> mesh; ///< null: nothing usable lies in the buffers
        MeshBuffers buffers;
    };

    const Gl* gl_;
    std::array<Slot, 2> slots_;
    std::size_t current_ = 0;
    std::uint64_t uploads_ = 0;
    std::uint64_t uploadedBytes_ = 0;
};

} // namespace reflectance
