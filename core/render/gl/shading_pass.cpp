#include "core/render/gl/shading_pass.h"

#include "core/math/angle.h"
#include "core/render/gl/model_uniforms.h"
#include "core/render/gl/ray_uniforms.h"

#include <cmath>

namespace reflectance {
namespace {

enum Unit { Normals, Positions, Lights, Map, MeasuredTexels, Triangles };

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
    define(place == Place::Fragment, "ONCE_PER_FRAGMENT");
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

ShadingPass::ShadingPass(ProgramLinker& linker)
    : gl_(&linker.gl()), linker_(&linker), linear_(*gl_, {GL_RGBA32F}, WithDepth::No),
      coverage_(*gl_, {}, WithDepth::Yes), fullScreen_(*gl_), lights_(*gl_), environmentMap_(*gl_), table_(*gl_)
{
}

void ShadingPass::resize(const RenderSettings& settings, const VisibilityPass& seen)
{
    if (linear_.width() != settings.width || linear_.height() != settings.height)
        linear_.resize(settings.width, settings.height);
    samplesPerAxis_ = settings.samplesPerAxis;
    // A pixel's only sample has the pixel's depth.
    const bool countsSamples = samplesPerAxis_ > 1;
    coverage_.resize(countsSamples ? settings.width : 0, countsSamples ? settings.height : 0);
    linear_.shareDepthOf(countsSamples ? coverage_ : seen.triangles());
    samplesChanged();
}

void ShadingPass::samplesChanged()
{
    covered_ = samplesPerAxis_ == 1;
    around_.reset();
}

void ShadingPass::keepIn(bool halfBuffer)
{
    if (halfBuffer == halfBuffer_)
        return;
    const int width = linear_.width();
    const int height = linear_.height();
    RenderTarget other(*gl_, {halfBuffer ? GLenum{GL_RGBA16F} : GLenum{GL_RGBA32F}}, WithDepth::No);
    other.resize(width, height);
    other.shareDepthOf(linear_);
    linear_ = std::move(other);
    halfBuffer_ = halfBuffer;
    around_.reset();
}

/// Writes a depth wherever a sample of the pixel sees something.
Result<void> ShadingPass::cover(const RenderTarget& triangles)
{
    const auto found = programs_.find("coverage", [&] {
        return GlProgram::link(*linker_, assembled({}, {shaderFile("gl/fullscreen.vert")}),
                               assembled({}, {shaderFile("gl/coverage.frag")}));
    });
    if (!found)
        return found.error();
    const GlProgram& program = **found;
    program.use();
    triangles.bindAsInput(0, Unit::Triangles);
    program.set("triangles", Unit::Triangles);
    program.set("samplesPerAxis", samplesPerAxis_);
    constexpr float farthest = 1.0F;
    coverage_.bind();
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_ALWAYS);
    gl_->DepthMask(GL_TRUE);
    gl_->ClearBufferfv(GL_DEPTH, 0, &farthest);
    fullScreen_.draw();
    gl_->DepthMask(GL_FALSE);
    gl_->Disable(GL_DEPTH_TEST);
    covered_ = true;
    return {};
}

/// Runs the program only in pixels that were covered; the others are of the background's colour.
void ShadingPass::drawCovered(const Vec3d& background)
{
    const Vec3f color(background);
    const float uncovered[] = {color.x, color.y, color.z, 0.0F};
    if (around_ != background)
        gl_->ClearBufferfv(GL_COLOR, 0, uncovered);
    around_ = background;
    fullScreen_.drawWhereSeen();
}

Result<const GlProgram*> ShadingPass::programFor(const Requirements& requirements, Place place)
{
    return programs_.find(requirements.key() + "+" + std::string(nameOf(place)), [&]() -> Result<GlProgram> {
        return GlProgram::link(*linker_, assembled({}, {shaderFile("gl/fullscreen.vert")}),
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

Result<void> ShadingPass::draw(const VisibilityPass& seen, const ShadingInputs& inputs, const Camera& camera,
                               const RenderSettings& settings)
{
    const RenderTarget& samples = seen.surface();
    keepIn(inputs.how.halfBuffer);
    const bool everywhere = inputs.requirements.environmentBackground;
    if (!everywhere && !covered_)
        if (auto done = cover(seen.triangles()); !done)
            return done;
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
    seen.triangles().bindAsInput(0, Unit::Triangles);
    program.set("triangles", Unit::Triangles);
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
    linear_.bind();
    if (everywhere) {
        around_.reset();
        fullScreen_.draw();
    } else {
        drawCovered(inputs.background.color);
    }
    return {};
}

} // namespace reflectance
