#include "core/render/gl/visibility_pass.h"

#include "core/render/gl/ray_uniforms.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

namespace reflectance {

VisibilityPass::VisibilityPass(const Gl& gl, GlProgram rasterising, GlProgram locating)
    : gl_(&gl), rasterising_(std::move(rasterising)), locating_(std::move(locating)),
      triangles_(gl, {GL_R32UI}, WithDepth::Yes), surface_(gl, {GL_RGBA32F}, WithDepth::No), fullScreen_(gl)
{
    surface_.shareDepthOf(triangles_);
}

Result<VisibilityPass> VisibilityPass::create(ProgramLinker& linker)
{
    auto rasterising = GlProgram::link(linker, assembled({}, {shaderFile("gl/visibility.vert")}),
                                       assembled({}, {shaderFile("gl/visibility.frag")}));
    if (!rasterising)
        return rasterising.error();
    auto locating = GlProgram::link(linker, assembled({}, {shaderFile("gl/fullscreen.vert")}),
                                    assembled({}, {shaderFile("gl/rays.glsl"), shaderFile("gl/surface.frag")}));
    if (!locating)
        return locating.error();
    return VisibilityPass(linker.gl(), *std::move(rasterising), *std::move(locating));
}

void VisibilityPass::resize(const RenderSettings& settings)
{
    const int width = settings.width * settings.samplesPerAxis;
    const int height = settings.height * settings.samplesPerAxis;
    triangles_.resize(width, height);
    surface_.resize(width, height);
}

void VisibilityPass::keepPositions()
{
    const int width = surface_.width();
    const int height = surface_.height();
    surface_ = RenderTarget(*gl_, {GL_RGBA32F, GL_RGBA32F}, WithDepth::No);
    surface_.shareDepthOf(triangles_);
    if (width > 0)
        surface_.resize(width, height);
}

RenderTarget VisibilityPass::located(const MeshBuffers& mesh, const Camera& camera,
                                     const RenderSettings& settings) const
{
    RenderTarget surface(*gl_, {GL_RGBA32F, GL_RGBA32F}, WithDepth::No);
    surface.shareDepthOf(triangles_);
    surface.resize(surface_.width(), surface_.height());
    locate(mesh, camera, settings, surface);
    return surface;
}

void VisibilityPass::draw(const MeshBuffers& mesh, const Camera& camera, const RenderSettings& settings) const
{
    rasterise(mesh, camera);
    locate(mesh, camera, settings, surface_);
}

void VisibilityPass::rasterise(const MeshBuffers& mesh, const Camera& camera) const
{
    const double aspect = static_cast<double>(triangles_.width()) / triangles_.height();
    const glm::mat4 clipFromWorld(clipFromView(camera, aspect) * viewFromWorld(camera));
    constexpr GLuint nothing[] = {0, 0, 0, 0};
    constexpr float farthest = 1.0F;
    triangles_.bind();
    gl_->DepthMask(GL_TRUE);
    gl_->ClearBufferuiv(GL_COLOR, 0, nothing);
    gl_->ClearBufferfv(GL_DEPTH, 0, &farthest);
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    rasterising_.use();
    rasterising_.setColumns("clipFromWorld", glm::value_ptr(clipFromWorld));
    mesh.draw();
    gl_->Disable(GL_DEPTH_TEST);
}

void VisibilityPass::locate(const MeshBuffers& mesh, const Camera& camera, const RenderSettings& settings,
                            const RenderTarget& surface) const
{
    enum Unit { Triangles, Corners, Vertices };
    locating_.use();
    triangles_.bindAsInput(0, Unit::Triangles);
    mesh.bindCorners(Unit::Corners);
    mesh.bindVertices(Unit::Vertices);
    locating_.set("triangles", Unit::Triangles);
    locating_.set("corners", Unit::Corners);
    locating_.set("vertices", Unit::Vertices);
    locating_.set("eye", camera.eye);
    setRays(locating_, camera, settings);
    surface.bind();
    fullScreen_.drawWhereSeen();
}

} // namespace reflectance
