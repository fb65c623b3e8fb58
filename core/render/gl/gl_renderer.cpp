#include "core/render/gl/gl_renderer.h"

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/render/gl/draw_clock.h"
#include "core/render/gl/evaluate_pass.h"
#include "core/render/gl/gl_functions.h"
#include "core/render/gl/sample_reader.h"
#include "core/render/gl/sensor_pass.h"
#include "core/render/gl/shading_pass.h"
#include "core/render/gl/uploaded_meshes.h"
#include "core/render/gl/visibility_pass.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace reflectance {
namespace {

/// What the kept samples depend on.
struct ViewInputs {
    std::shared_ptr<const Mesh> mesh;
    Camera camera;
    RenderSettings settings;

    friend bool operator==(const ViewInputs&, const ViewInputs&) = default;
};

/// The state that the passes rely on; a window's own drawing may have left anything.
void prepareState(const Gl& gl)
{
    constexpr GLenum features[] = {GL_BLEND,      GL_SCISSOR_TEST, GL_STENCIL_TEST,     GL_CULL_FACE,
                                   GL_DEPTH_TEST, GL_DITHER,       GL_FRAMEBUFFER_SRGB, GL_RASTERIZER_DISCARD};
    for (const GLenum feature : features)
        gl.Disable(feature);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.FrontFace(GL_CCW);
    gl.BindSampler(0, 0);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.PixelStorei(GL_PACK_ROW_LENGTH, 0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
}

void leaveState(const Gl& gl)
{
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.BindVertexArray(0);
    gl.UseProgram(0);
    gl.ActiveTexture(GL_TEXTURE0);
}

} // namespace

struct GlRenderer::State {
    State(std::unique_ptr<GlFunctions> loaded, std::unique_ptr<ProgramLinker> made, VisibilityPass first)
        : functions(std::move(loaded)), linker(std::move(made)), meshes(functions->gl()), visibility(std::move(first)),
          shading(*linker), sensor(*linker), reader(functions->gl())
    {
    }

    /// Refuses what the driver cannot hold, before anything is allocated.
    [[nodiscard]] Result<void> fits(const RenderSettings& settings) const;
    void allocate(const RenderSettings& settings);
    [[nodiscard]] Result<void> see(const ViewInputs& view);
    [[nodiscard]] Result<void> shade(const ShadingInputs& inputs);
    [[nodiscard]] Result<void> develop(const Sensor& settings);
    /// Runs the passes whose inputs changed, up to the linear picture.
    [[nodiscard]] Result<void> update(const Scene& scene, const RenderSettings& settings, const GlShading& how);

    /// Leaves GL as a window expects it. What `done` says goes before what the driver says about it.
    template <class T> [[nodiscard]] Result<T> closed(Result<T> done)
    {
        leaveState(functions->gl());
        work.tableUploads = shading.tableUploads();
        work.uploadedBytes = meshes.uploadedBytes() + shading.uploadedBytes();
        work.targetBytes = visibility.bytes() + shading.bytes() + sensor.developed().bytes();
        work.programLinks = 2 + sensor.programs() + shading.programs() + (evaluation ? evaluation->programs() : 0);
        work.programsLoaded = linker->loaded();
        const auto complaint = functions->complaint();
        return done && !complaint ? Result<T>(complaint.error()) : std::move(done);
    }

    std::unique_ptr<GlFunctions> functions; // first in, last out: the passes return their names through it
    std::unique_ptr<ProgramLinker> linker;  // the passes hold its address
    UploadedMeshes meshes;
    VisibilityPass visibility;
    ShadingPass shading;
    SensorPass sensor;
    SampleReader reader;
    std::optional<EvaluatePass> evaluation; // made when first asked for
    GlWork work;

    // The inputs of the last run of each pass; none until it ran, and after a pass before it ran anew.
    std::optional<RenderSettings> allocated;
    std::optional<ViewInputs> seen;
    std::optional<ShadingInputs> shaded;
    std::optional<Sensor> developed;
};

Result<void> GlRenderer::State::fits(const RenderSettings& s) const
{
    GLint limit = 0;
    functions->gl().GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    const long across = static_cast<long>(s.width) * s.samplesPerAxis;
    const long down = static_cast<long>(s.height) * s.samplesPerAxis;
    constexpr double bytesPerSample = 4 + 4 + 16 + 16; // triangle, depth, N, P
    constexpr double bytesPerPixel = 16 + 4 + 4;       // linear, its coverage, developed
    constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
    const double needed = static_cast<double>(across) * static_cast<double>(down) * bytesPerSample +
                          static_cast<double>(s.width) * s.height * bytesPerPixel;
    const std::string size = std::to_string(s.width) + "x" + std::to_string(s.height) + " with " +
                             std::to_string(s.samplesPerAxis * s.samplesPerAxis) + " samples per pixel";
    if (across > limit || down > limit)
        return Error{size + " needs a texture of " + std::to_string(std::max(across, down)) + ", OpenGL here has " +
                     std::to_string(limit) + "; use fewer samples or --backend cpu"};
    if (needed > 2.0 * gibibyte)
        return Error{size + " needs " + general(needed / gibibyte, 2) +
                     " GiB on the graphics card, more than the 2 GiB allowed; use fewer samples or --backend cpu"};
    return {};
}

void GlRenderer::State::allocate(const RenderSettings& settings)
{
    visibility.resize(settings);
    shading.resize(settings, visibility);
    if (!allocated || allocated->width != settings.width || allocated->height != settings.height)
        sensor.resize(settings);
    allocated = settings;
    seen.reset();
    ++work.allocations;
}

Result<void> GlRenderer::State::see(const ViewInputs& view)
{
    seen.reset();
    shaded.reset();
    const auto mesh = meshes.buffersOf(view.mesh);
    work.meshUploads = meshes.uploads();
    if (!mesh)
        return mesh.error();
    visibility.draw(**mesh, view.camera, view.settings);
    shading.samplesChanged();
    sensor.samplesChanged();
    ++work.visibilities;
    seen = view;
    return {};
}

Result<void> GlRenderer::State::shade(const ShadingInputs& inputs)
{
    shaded.reset();
    developed.reset();
    if (auto drawn = shading.draw(visibility, inputs, seen->camera, seen->settings); !drawn)
        return drawn;
    ++work.shadings;
    shaded = inputs;
    return {};
}

Result<void> GlRenderer::State::develop(const Sensor& settings)
{
    developed.reset();
    if (auto drawn = sensor.draw(shading.linear(), settings, shading.around()); !drawn)
        return drawn;
    ++work.developments;
    developed = settings;
    return {};
}

Result<void> GlRenderer::State::update(const Scene& scene, const RenderSettings& settings, const GlShading& how)
{
    const ShadingInputs inputs = shadingInputsOf(scene, how);
    // Once needed they stay, so that a slider that goes to 0 and back does not allocate at every turn.
    if (inputs.requirements.positions && !visibility.keepsPositions()) {
        visibility.keepPositions();
        work.allocations += allocated == settings ? 1 : 0;
        seen.reset();
    }
    if (allocated != settings) {
        if (auto fit = fits(settings); !fit)
            return fit;
        allocate(settings);
    }
    const ViewInputs view{scene.mesh, scene.camera, settings};
    if (seen != view) {
        if (auto done = see(view); !done)
            return done;
    }
    return shaded == inputs ? Result<void>() : shade(inputs);
}

bool isSoftware(std::string_view description)
{
    constexpr std::string_view names[] = {"llvmpipe", "softpipe", "swrast", "SwiftShader", "Software"};
    return std::any_of(std::begin(names), std::end(names),
                       [&](std::string_view name) { return description.find(name) != std::string_view::npos; });
}

GlRenderer::GlRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
GlRenderer::GlRenderer(GlRenderer&&) noexcept = default;
GlRenderer& GlRenderer::operator=(GlRenderer&&) noexcept = default;
GlRenderer::~GlRenderer() = default;

Result<GlRenderer> GlRenderer::create(GetProcAddress load, const std::filesystem::path& programs)
{
    auto functions = GlFunctions::load(load);
    if (!functions)
        return functions.error();
    auto linker = std::make_unique<ProgramLinker>((*functions)->gl(), programs);
    auto visibility = VisibilityPass::create(*linker);
    if (!visibility)
        return visibility.error();
    auto state = std::make_unique<State>(*std::move(functions), std::move(linker), *std::move(visibility));
    if (auto quiet = state->closed(Result<void>()); !quiet)
        return quiet.error();
    return GlRenderer(std::move(state));
}

Result<void> GlRenderer::render(const Scene& scene, const RenderSettings& settings, const GlShading& how)
{
    auto drawn = renderLinear(scene, settings, how);
    if (!drawn || state_->developed == scene.sensor)
        return drawn;
    prepareState(state_->functions->gl());
    return state_->closed(state_->develop(scene.sensor));
}

Result<void> GlRenderer::renderLinear(const Scene& scene, const RenderSettings& settings, const GlShading& how)
{
    CHECK_EQ(scene.mesh != nullptr, true);
    CHECK_LE(static_cast<int>(how.place), static_cast<int>(Place::Pixel));
    prepareState(state_->functions->gl());
    return state_->closed(state_->update(scene, settings, how));
}

void GlRenderer::invalidateShading()
{
    state_->shaded.reset();
}

void GlRenderer::invalidateSamples()
{
    state_->seen.reset();
}

unsigned GlRenderer::developedTexture() const
{
    return state_->sensor.developed().texture(0);
}

Image GlRenderer::readLinear()
{
    return state_->reader.readImage(state_->shading.linear());
}

ViewSamples GlRenderer::readSamples()
{
    CHECK_EQ(state_->seen.has_value(), true);
    const ViewInputs& view = *state_->seen;
    State& s = *state_;
    if (s.visibility.keepsPositions())
        return s.reader.readSamples(s.visibility.triangles(), s.visibility.surface(), view.settings, view.camera.eye);
    prepareState(s.functions->gl());
    const RenderTarget surface = s.visibility.located(**s.meshes.buffersOf(view.mesh), view.camera, view.settings);
    ViewSamples samples = s.reader.readSamples(s.visibility.triangles(), surface, view.settings, view.camera.eye);
    leaveState(s.functions->gl());
    return samples;
}

double GlRenderer::millisecondsOf(const std::function<void()>& work)
{
    const Gl& gl = state_->functions->gl();
    return isSoftware(description()) ? wallMillisecondsOf(gl, work) : cardMillisecondsOf(gl, work);
}

void GlRenderer::finish()
{
    state_->functions->gl().Finish();
}

Result<std::vector<Vec3d>> GlRenderer::evaluate(const Model& model, std::span<const double> values,
                                                std::span<const Observation> rows,
                                                const std::shared_ptr<const MeasuredTable>& table, LobeForm lobe)
{
    State& s = *state_;
    prepareState(s.functions->gl());
    if (!s.evaluation)
        s.evaluation.emplace(*s.linker);
    return s.closed(s.evaluation->run(model, values, rows, table, lobe));
}

const GlWork& GlRenderer::work() const
{
    return state_->work;
}

std::string GlRenderer::description() const
{
    const Gl& gl = state_->functions->gl();
    const auto text = [&gl](GLenum name) { return std::string(reinterpret_cast<const char*>(gl.GetString(name))); };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

} // namespace reflectance
