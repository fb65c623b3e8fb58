#include "core/render/gl/sensor_pass.h"

namespace reflectance {

SensorPass::SensorPass(const Gl& gl, GlProgram program)
    : gl_(&gl), program_(std::move(program)), developed_(gl, {GL_RGBA8}, WithDepth::No), noVertices_(gl)
{
}

Result<SensorPass> SensorPass::create(const Gl& gl)
{
    auto program = GlProgram::link(gl, assembled({}, {shaderFile("gl/fullscreen.vert")}),
                                   assembled({}, {shaderFile("sensor/develop.glsl"), shaderFile("gl/sensor.frag")}));
    if (!program)
        return program.error();
    return SensorPass(gl, *std::move(program));
}

void SensorPass::resize(const RenderSettings& settings)
{
    developed_.resize(settings.width, settings.height);
}

void SensorPass::draw(const RenderTarget& linear, const Sensor& sensor) const
{
    program_.use();
    linear.bindAsInput(0, 0);
    program_.set("linearPicture", 0);
    program_.set("exposure", static_cast<float>(sensor.exposure));
    developed_.bind();
    gl_->BindVertexArray(noVertices_.id());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace reflectance
