#include "core/render/gl/sensor_pass.h"

#include "core/sensor/inputs.h"

namespace reflectance {
namespace {

constexpr int curveUnit = 1;

/// In the order in which one calls the other, as core/sensor/CMakeLists.txt joins them.
std::vector<ShaderPiece> sensorPieces()
{
    std::vector<ShaderPiece> pieces;
    for (const char* part :
         {"exposure", "vignetting", "noise", "well", "balance", "response", "encode", "quantise", "view", "develop"})
        pieces.push_back(shaderFile(std::string("sensor/") + part + ".glsl"));
    pieces.push_back(shaderFile("gl/sensor.frag"));
    return pieces;
}

} // namespace

SensorPass::SensorPass(const Gl& gl, GlProgram program)
    : gl_(&gl), program_(std::move(program)), developed_(gl, {GL_RGBA8}, WithDepth::No), noVertices_(gl),
      curveBuffer_(gl), curveTexture_(gl)
{
}

Result<SensorPass> SensorPass::create(const Gl& gl)
{
    auto program =
        GlProgram::link(gl, assembled({}, {shaderFile("gl/fullscreen.vert")}), assembled({}, sensorPieces()));
    if (!program)
        return program.error();
    return SensorPass(gl, *std::move(program));
}

void SensorPass::resize(const RenderSettings& settings)
{
    developed_.resize(settings.width, settings.height);
}

void SensorPass::setInputs(const Sensor& sensor) const
{
    const SensorInputs inputs = inputsOf(sensor);
    const auto set = [this](const char* name, double value) { program_.set(name, static_cast<float>(value)); };
    set("gain", inputs.gain);
    program_.set("vignettingKind", inputs.vignettingKind);
    set("cornerTangent", inputs.cornerTangent);
    program_.set("fallOff", inputs.fallOff);
    program_.set("noiseOn", inputs.noiseOn);
    set("shotVariance", inputs.shotVariance);
    set("readVariance", inputs.readVariance);
    program_.set("seed", inputs.seed);
    program_.set("wellOn", inputs.wellOn);
    set("wellLimit", inputs.wellLimit);
    program_.set("balanceOn", inputs.balanceOn);
    program_.set("balanceRed", inputs.balanceRows[0]);
    program_.set("balanceGreen", inputs.balanceRows[1]);
    program_.set("balanceBlue", inputs.balanceRows[2]);
    program_.set("responseKind", inputs.responseKind);
    set("responsePower", inputs.responsePower);
    program_.set("responseCount", inputs.responseCount);
    program_.set("encoding", inputs.encoding);
    set("levels", inputs.levels);
    program_.set("dithered", inputs.dithered);
    program_.set("viewKind", inputs.viewKind);
    program_.set("marks", inputs.marks);
    program_.set("falseColors", std::span<const float>(falseColors()));
}

void SensorPass::showCurve(const Response& response)
{
    // Always another unit than the picture's: samplers of two kinds may not share one, looked up or not.
    program_.set("responseTexels", curveUnit);
    gl_->ActiveTexture(GL_TEXTURE0 + curveUnit);
    if (response.curve && response.curve != curve_) {
        gl_->BindBuffer(GL_TEXTURE_BUFFER, curveBuffer_.id());
        gl_->BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(response.curve->texels.size() * sizeof(float)),
                        response.curve->texels.data(), GL_STATIC_DRAW);
        gl_->BindTexture(GL_TEXTURE_BUFFER, curveTexture_.id());
        gl_->TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, curveBuffer_.id());
        curve_ = response.curve;
    }
    gl_->BindTexture(GL_TEXTURE_BUFFER, curve_ ? curveTexture_.id() : 0);
}

void SensorPass::draw(const RenderTarget& linear, const Sensor& sensor)
{
    program_.use();
    showCurve(sensor.response);
    linear.bindAsInput(0, 0);
    program_.set("linearPicture", 0);
    setInputs(sensor);
    developed_.bind();
    gl_->BindVertexArray(noVertices_.id());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace reflectance
