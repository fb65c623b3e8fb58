// A mesh on the GPU: position and normal of each vertex as floats, and the triangles' indices.
#pragma once

#include "core/geometry/mesh.h"
#include "core/render/gl/gl_objects.h"

namespace reflectance {

class MeshBuffers {
public:
    explicit MeshBuffers(const Gl& gl);

    void upload(const Mesh& mesh);
    void draw() const;

private:
    GlVertexArray layout_;
    GlBuffer vertices_;
    GlBuffer indices_;
    GLsizei indexCount_ = 0;
};

} // namespace reflectance
