// The first pass: what each sample of the view sees, kept for as many shadings as wanted. The rasteriser says which
// triangle; the point on it and its normal are computed from the triangle itself.
#pragma once

#include "core/geometry/camera.h"
#include "core/render/gl/full_screen.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/mesh_buffers.h"
#include "core/render/gl/render_target.h"
#include "core/render/settings.h"

namespace reflectance {

class VisibilityPass {
public:
    [[nodiscard]] static Result<VisibilityPass> create(ProgramLinker& linker);

    void resize(const RenderSettings& settings);

    /// From the next draw on P is kept beside N; before, there is no texture of it.
    void keepPositions();
    [[nodiscard]] bool keepsPositions() const { return surface_.textures() == 2; }

    void draw(const MeshBuffers& mesh, const Camera& camera, const RenderSettings& settings) const;

    [[nodiscard]] std::uint64_t bytes() const { return triangles_.bytes() + surface_.bytes(); }

    /// R32UI: 1 + the triangle's number, 0 where nothing was hit; and the depths, those of a cleared target there.
    [[nodiscard]] const RenderTarget& triangles() const { return triangles_; }
    /// What surface() would hold if positions were kept, of the view that was drawn last.
    [[nodiscard]] RenderTarget located(const MeshBuffers& mesh, const Camera& camera,
                                       const RenderSettings& settings) const;

    /// Texture 0: N; texture 1, where it is kept: P. Both are undefined where triangles() says that nothing was hit.
    [[nodiscard]] const RenderTarget& surface() const { return surface_; }

private:
    VisibilityPass(const Gl& gl, GlProgram rasterising, GlProgram locating);

    void rasterise(const MeshBuffers& mesh, const Camera& camera) const;
    void locate(const MeshBuffers& mesh, const Camera& camera, const RenderSettings& settings,
                const RenderTarget& surface) const;

    const Gl* gl_;
    GlProgram rasterising_;
    GlProgram locating_;
    RenderTarget triangles_;
    RenderTarget surface_;
    FullScreen fullScreen_;
};

} // namespace reflectance
