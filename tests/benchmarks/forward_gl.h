// The least that an OpenGL program needs to draw a shaded mesh: the yardstick of the GL renderer. One pass, no kept
// samples; the arithmetic of surface and lights is the renderer's own.
#pragma once

#include "core/render/gl/gl_functions.h"
#include "core/render/gl/gl_objects.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/light_texels.h"
#include "core/render/gl/render_target.h"
#include "core/scene/scene.h"

namespace reflectance::bench {

class ForwardGl {
public:
    /// Stops the program with a sentence where anything fails. The context must stay current.
    ForwardGl(GetProcAddress load, const Scene& scene, int size);

    /// The mesh, into a float buffer.
    void drawMesh(const Camera& camera);
    /// The same shading on one triangle that covers the picture: of a sphere that covers 45 % of it.
    void drawFullScreen();
    void finish() const { functions_->gl().Finish(); }

private:
    void prepare(const GlProgram& program, const Camera& camera) const;

    std::unique_ptr<GlFunctions> functions_;
    const Scene& scene_;
    RenderTarget target_;
    GlVertexArray layout_, noVertices_;
    GlBuffer vertices_, indices_;
    LightBuffer lights_;
    std::vector<GlProgram> programs_; ///< of the mesh, of the full screen
    GLsizei indexCount_ = 0;
};

} // namespace reflectance::bench
