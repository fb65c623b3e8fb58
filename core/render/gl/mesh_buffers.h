// A mesh on the GPU, once, for two readers: the rasteriser (attributes and indices) and shaders that look up a triangle's
// corners by number (buffer textures).
#pragma once

#include "core/geometry/mesh.h"
#include "core/render/gl/gl_objects.h"

namespace reflectance {

class MeshBuffers {
public:
    explicit MeshBuffers(const Gl& gl);

    /// Refuses a mesh that is larger than this driver's buffer textures.
    [[nodiscard]] Result<void> upload(const Mesh& mesh);
    void draw() const;
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; } ///< of the mesh that is there

    /// Two RGBA32F texels per vertex: position, normal.
    void bindVertices(int unit) const;
    /// Three R32UI texels per triangle: the vertex numbers.
    void bindCorners(int unit) const;

private:
    GlVertexArray layout_;
    GlBuffer vertices_;
    GlBuffer indices_;
    GlTexture vertexTexels_;
    GlTexture cornerTexels_;
    GLsizei indexCount_ = 0;
    std::uint64_t bytes_ = 0;
};

} // namespace reflectance
