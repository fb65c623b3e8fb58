#include "core/render/gl/uploaded_meshes.h"

#include <algorithm>

namespace reflectance {
namespace {

bool mayLieTogether(const Mesh& a, const Mesh& b)
{
    const std::size_t fewer = std::min(a.triangles.size(), b.triangles.size());
    const std::size_t more = std::max(a.triangles.size(), b.triangles.size());
    return fewer <= more / 4;
}

} // namespace

Result<const MeshBuffers*> UploadedMeshes::buffersOf(const std::shared_ptr<const Mesh>& mesh)
{
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (slots_[i].mesh == mesh) {
            current_ = i;
            return &slots_[i].buffers;
        }
    const std::shared_ptr<const Mesh>& before = slots_[current_].mesh;
    Slot& other = slots_[1 - current_];
    if (before && mayLieTogether(*before, *mesh))
        current_ = 1 - current_;
    else if (other.mesh)
        other = {nullptr, MeshBuffers(*gl_)}; // gives its memory back
    Slot& slot = slots_[current_];
    slot.mesh.reset();
    if (auto done = slot.buffers.upload(*mesh); !done)
        return done.error();
    slot.mesh = mesh;
    ++uploads_;
    uploadedBytes_ += slot.buffers.bytes();
    return &slot.buffers;
}

} // namespace reflectance
