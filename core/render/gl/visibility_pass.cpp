#include "core/render/gl/visibility_pass.h"

#include <glm/mat4x4.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace reflectance {

VisibilityPass::VisibilityPass(const Gl& gl, GlProgram program)
    : gl_(&gl), program_(std::move(program)), samples_(gl, {GL_RGBA32F, GL_RGBA32F}, WithDepth::Yes)
{
}

Result<VisibilityPass> VisibilityPass::create(const Gl& gl)
{
    auto program = GlProgram::link(gl, assembled({}, {shaderFile("gl/visibility.vert")}),
                                   assembled({}, {shaderFile("gl/visibility.frag")}));
    if (!program)
        return program.error();
    return VisibilityPass(gl, *std::move(program));
}

void VisibilityPass::resize(const RenderSettings& settings)
{
    samples_.resize(settings.width * settings.samplesPerAxis, settings.height * settings.samplesPerAxis);
}

void VisibilityPass::draw(const MeshBuffers& mesh, const Camera& camera) const
{
    const double aspect = static_cast<double>(samples_.width()) / samples_.height();
    const glm::mat4 clipFromWorld(clipFromView(camera, aspect) * viewFromWorld(camera));
    constexpr float nothing[] = {0.0F, 0.0F, 0.0F, 0.0F};
    constexpr float farthest = 1.0F;
    samples_.bind();
    gl_->DepthMask(GL_TRUE);
    gl_->ClearBufferfv(GL_COLOR, 0, nothing);
    gl_->ClearBufferfv(GL_COLOR, 1, nothing);
    gl_->ClearBufferfv(GL_DEPTH, 0, &farthest);
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    program_.use();
    program_.setColumns("clipFromWorld", glm::value_ptr(clipFromWorld));
    mesh.draw();
    gl_->Disable(GL_DEPTH_TEST);
}

} // namespace reflectance
