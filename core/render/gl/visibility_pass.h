// The first pass: what each sample of the view sees, kept for as many shadings as wanted.
#pragma once

#include "core/geometry/camera.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/mesh_buffers.h"
#include "core/render/gl/render_target.h"
#include "core/render/settings.h"

namespace reflectance {

class VisibilityPass {
public:
    [[nodiscard]] static Result<VisibilityPass> create(const Gl& gl);

    void resize(const RenderSettings& settings);
    void draw(const MeshBuffers& mesh, const Camera& camera) const;

    /// Texture 0: N and hit flag; texture 1: P and tag. See shaders/gl/visibility.frag.
    [[nodiscard]] const RenderTarget& samples() const { return samples_; }

private:
    VisibilityPass(const Gl& gl, GlProgram program);

    const Gl* gl_;
    GlProgram program_;
    RenderTarget samples_;
};

} // namespace reflectance
