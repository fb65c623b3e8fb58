#include "core/render/gl/sensor_pass.h"

#include "core/base/check.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr int curveUnit = 1;

/// A choice that decides which of the sensor's code runs. Compiled in as a constant: software drivers run every branch that
/// a uniform might take, noise and curves of a sensor that has neither included.
struct Switch {
    const char* name;
    int value;
};

std::array<Switch, 9> switchesOf(const SensorInputs& inputs)
{
    return {{{"vignettingKind", inputs.vignettingKind},
             {"noiseOn", inputs.noiseOn},
             {"wellOn", inputs.wellOn},
             {"balanceOn", inputs.balanceOn},
             {"responseKind", inputs.responseKind},
             {"encoding", inputs.encoding},
             {"dithered", inputs.dithered},
             {"viewKind", inputs.viewKind},
             {"marks", inputs.marks}}};
}

std::string keyOf(std::span<const Switch> switches)
{
    std::string key;
    for (const Switch& one : switches)
        key += std::to_string(one.value) + " ";
    return key;
}

/// Turns `uniform int name = default;` into a constant; true if the text declares it.
bool fix(std::string& text, const Switch& one)
{
    const std::string declaration = "uniform int " + std::string(one.name) + " =";
    const std::size_t at = text.find(declaration);
    if (at == std::string::npos)
        return false;
    text.replace(at, text.find(';', at) - at, "const int " + std::string(one.name) + " = " + std::to_string(one.value));
    return true;
}

/// In the order in which one calls the other, as core/sensor/CMakeLists.txt joins them.
std::vector<ShaderPiece> sensorPieces(std::span<const Switch> switches)
{
    std::vector<ShaderPiece> pieces;
    for (const char* part :
         {"exposure", "vignetting", "noise", "well", "balance", "response", "encode", "quantise", "view", "develop"})
        pieces.push_back(shaderFile(std::string("sensor/") + part + ".glsl"));
    for (const Switch& one : switches)
        CHECK_EQ(std::count_if(pieces.begin(), pieces.end(), [&one](ShaderPiece& p) { return fix(p.text, one); }), 1);
    pieces.push_back(shaderFile("gl/sensor.frag"));
    return pieces;
}

} // namespace

SensorPass::SensorPass(ProgramLinker& linker)
    : gl_(&linker.gl()), linker_(&linker), developed_(*gl_, {GL_RGBA8}, WithDepth::No), fullScreen_(*gl_),
      curveBuffer_(*gl_), curveTexture_(*gl_)
{
}

void SensorPass::resize(const RenderSettings& settings)
{
    developed_.resize(settings.width, settings.height);
    samplesChanged();
}

Result<const GlProgram*> SensorPass::programFor(const SensorInputs& inputs)
{
    const auto switches = switchesOf(inputs);
    return programs_.find(keyOf(switches), [&] {
        return GlProgram::link(*linker_, assembled({}, {shaderFile("gl/fullscreen.vert")}),
                               assembled({}, sensorPieces(switches)));
    });
}

void SensorPass::setInputs(const GlProgram& program, const SensorInputs& inputs)
{
    const auto set = [&program](const char* name, double value) { program.set(name, static_cast<float>(value)); };
    set("gain", inputs.gain);
    set("cornerTangent", inputs.cornerTangent);
    program.set("fallOff", inputs.fallOff);
    set("shotVariance", inputs.shotVariance);
    set("readVariance", inputs.readVariance);
    program.set("seed", inputs.seed);
    set("wellLimit", inputs.wellLimit);
    program.set("balanceRed", inputs.balanceRows[0]);
    program.set("balanceGreen", inputs.balanceRows[1]);
    program.set("balanceBlue", inputs.balanceRows[2]);
    set("responsePower", inputs.responsePower);
    program.set("responseCount", inputs.responseCount);
    set("levels", inputs.levels);
    program.set("falseColors", std::span<const float>(falseColors()));
}

void SensorPass::showCurve(const GlProgram& program, const Response& response)
{
    // Always another unit than the picture's: samplers of two kinds may not share one, looked up or not.
    program.set("responseTexels", curveUnit);
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

void SensorPass::paint(const Around& around) const
{
    Image one(1, 1);
    const Vec3d& radiance = around.radiance;
    one.rgb = {static_cast<float>(radiance.x), static_cast<float>(radiance.y), static_cast<float>(radiance.z)};
    const Vec3d code = developedAt(one, 0, 0, around.sensor);
    const auto rounded = [](double channel) { return static_cast<float>(quantised(channel)) / 255.0F; };
    const float color[] = {rounded(code.x), rounded(code.y), rounded(code.z), 1.0F};
    gl_->ClearBufferfv(GL_COLOR, 0, color);
}

/// Pixels that see nothing are painted at once, or keep what they show: the program runs in the others only.
void SensorPass::drawPicture(const RenderTarget& linear, const std::optional<Around>& around, bool alikeEverywhere)
{
    const bool isThere = around && around == around_;
    if (!isThere)
        developed_.shareDepthOf(linear);
    developed_.bind();
    if (!isThere && around && alikeEverywhere)
        paint(*around);
    if (isThere || (around && alikeEverywhere))
        fullScreen_.drawWhereSeen();
    else
        fullScreen_.draw();
    around_ = around;
}

Result<void> SensorPass::draw(const RenderTarget& linear, const Sensor& sensor, const std::optional<Vec3d>& around)
{
    const SensorInputs inputs = inputsOf(sensor);
    const auto found = programFor(inputs);
    if (!found)
        return found.error();
    const GlProgram& program = **found;
    program.use();
    showCurve(program, sensor.response);
    linear.bindAsInput(0, 0);
    program.set("linearPicture", 0);
    setInputs(program, inputs);
    drawPicture(linear, around ? std::optional(Around{sensor, *around}) : std::nullopt, isAlikeEverywhere(inputs));
    return {};
}

} // namespace reflectance
