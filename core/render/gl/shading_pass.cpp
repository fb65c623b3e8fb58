#include "core/render/gl/shading_pass.h"

#include "core/math/angle.h"
#include "core/render/gl/model_uniforms.h"
#include "core/render/gl/ray_uniforms.h"

#include <cmath>

namespace reflectance {
namespace {

enum Unit { Normals, Positions, Lights, Map, MeasuredTexels };

std::vector<std::string> definesFor(const Requirements& r, Place place)
{
    std::vector<std::string> names;
    const auto define = [&names](bool required, const char* name) {
        if (required)
            names.emplace_back(name);
    };
    define(r.directionalLights, "DIRECTIONAL_LIGHTS");
    define(r.pointLights, "POINT_LIGHTS");
    define(r.environment, "ENVIRONMENT");
    define(r.environmentBackground, "ENVIRONMENT_BACKGROUND");
    define(r.environmentMap, "ENVIRONMENT_MAP");
    define(r.holes, "TABLE_HOLES");
    define(r.positions, "POSITIONS");
    define(place == Place::Pixel, "ONCE_PER_PIXEL");
    return names;
}

ShaderSource sourceFor(const Requirements& r, const ModelText& model, Place place)
{
    std::vector<ShaderPiece> pieces = modelPieces(model, r.table, r.lobe, r.form);
    if (r.holes)
        pieces.push_back(shaderFile("measured/holes.glsl"));
    if (r.environment || r.environmentBackground) {
        pieces.push_back(shaderFile(r.environmentMap ? "illumination/map.glsl" : "illumination/studio.glsl"));
        pieces.push_back(shaderFile("gl/surroundings.glsl"));
    } else {
        pieces.push_back(shaderFile("gl/no_surroundings.glsl"));
    }
    pieces.push_back(shaderFile("gl/rays.glsl"));
    pieces.push_back(shaderFile("gl/arrival.glsl"));
    pieces.push_back(shaderFile("gl/shading.frag"));
    return assembled(definesFor(r, place), std::move(pieces));
}

} // namespace

ShadingPass::ShadingPass(const Gl& gl)
    : gl_(&gl), linear_(gl, {GL_RGBA32F}, WithDepth::No), noVertices_(gl), lights_(gl), environmentMap_(gl), table_(gl)
{
}

void ShadingPass::resize(const RenderSettings& settings)
{
    linear_.resize(settings.width, settings.height);
}

void ShadingPass::keepIn(bool halfBuffer)
{
    if (halfBuffer == halfBuffer_)
        return;
    const int width = linear_.width();
    const int height = linear_.height();
    linear_ = RenderTarget(*gl_, {halfBuffer ? GLenum{GL_RGBA16F} : GLenum{GL_RGBA32F}}, WithDepth::No);
    linear_.resize(width, height);
    halfBuffer_ = halfBuffer;
}

Result<const GlProgram*> ShadingPass::programFor(const Requirements& requirements, Place place)
{
    return programs_.find(requirements.key() + (place == Place::Pixel ? "+once" : ""), [&]() -> Result<GlProgram> {
        return GlProgram::link(*gl_, assembled({}, {shaderFile("gl/fullscreen.vert")}),
                               sourceFor(requirements, requirements.modelUsed().text, place));
    });
}

void ShadingPass::setLights(const GlProgram& program, const std::vector<float>& texels)
{
    if (texels != uploadedLights_) {
        lights_.upload(texels);
        uploadedLights_ = texels;
        lightBytes_ += texels.size() * sizeof(float);
    }
    lights_.bindAsInput(Unit::Lights);
    program.set("lightTexels", Unit::Lights);
    program.set("lightCount", static_cast<int>(texels.size() / floatsPerLight));
}

Result<void> ShadingPass::setEnvironment(const GlProgram& program, const ShadingInputs& inputs)
{
    const Environment& environment = inputs.environment;
    if (environment.kind == EnvironmentKind::None)
        return {};
    if (inputs.requirements.environmentMap) {
        if (auto shown = environmentMap_.show(environment.map); !shown)
            return shown;
        environmentMap_.bindAsInput(Unit::Map);
        program.set("environmentMap", Unit::Map);
    }
    const double turn = radians(environment.rotation);
    program.set("environmentFactor", environment.radiance);
    program.set("environmentTurn", std::array{static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn))});
    program.set("environmentIsConstant", environment.kind == EnvironmentKind::Constant ? 1 : 0);
    return {};
}

Result<void> ShadingPass::draw(const RenderTarget& samples, const ShadingInputs& inputs, const Camera& camera,
                               const RenderSettings& settings)
{
    const auto found = programFor(inputs.requirements, inputs.how.place);
    if (!found)
        return found.error();
    const GlProgram& program = **found;
    program.use();
    samples.bindAsInput(0, Unit::Normals);
    if (inputs.requirements.positions)
        samples.bindAsInput(1, Unit::Positions);
    program.set("normals", Unit::Normals);
    program.set("positions", Unit::Positions);
    program.set("samplesPerAxis", settings.samplesPerAxis);
    program.set("eye", camera.eye);
    program.set("backgroundColor", inputs.background.color);
    setRays(program, camera, settings);
    setLights(program, inputs.lights);
    if (auto set = setEnvironment(program, inputs); !set)
        return set;
    if (inputs.table)
        if (auto shown = table_.show(program, inputs.table, Unit::MeasuredTexels); !shown)
            return shown;
    const ModelText& model = inputs.requirements.modelUsed().text;
    uploadParameters(program, model, inputs.values, inputs.requirements.form);
    if (inputs.requirements.lobe == LobeForm::Table)
        uploadLobeTable(program, model, inputs.values);
    keepIn(inputs.how.halfBuffer);
    linear_.bind();
    gl_->BindVertexArray(noVertices_.id());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
    return {};
}

} // namespace reflectance
