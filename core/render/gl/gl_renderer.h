// The GL renderer: visibility once into a float G-buffer, then a full-screen shading pass, then the sensor pass.
// It is handed a symbol loader and draws in whatever context is current: GLFW's, OSMesa's or EGL's.
#pragma once

#include "core/image/image.h"
#include "core/reflectance/observation.h"
#include "core/render/gl/gl_shading.h"
#include "core/render/headless/headless_context.h"
#include "core/render/settings.h"
#include "core/render/view_samples.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// How often each kind of work was done since the renderer was made: a parameter drag must only raise `shadings`.
struct GlWork {
    std::uint64_t meshUploads = 0, visibilities = 0, shadings = 0, developments = 0, programLinks = 0, allocations = 0;
    std::uint64_t tableUploads = 0;
    std::uint64_t programsLoaded = 0; ///< of the programs linked: those that were kept on disk
    std::uint64_t uploadedBytes = 0;  ///< of meshes, lights, tables and surroundings
    std::uint64_t targetBytes = 0;    ///< what the kept samples and pictures take now
};

class GlRenderer {
public:
    /// The context must be current now and at every later call, the destructor included. Linked programs are kept in the
    /// folder `programs` from one start to the next, see ProgramLinker; an empty name: nowhere.
    [[nodiscard]] static Result<GlRenderer> create(GetProcAddress load, const std::filesystem::path& programs = {});
    GlRenderer(GlRenderer&&) noexcept;
    GlRenderer& operator=(GlRenderer&&) noexcept;
    ~GlRenderer();

    /// Brings the picture up to date; only the passes whose inputs changed run.
    [[nodiscard]] Result<void> render(const Scene& scene, const RenderSettings& settings, const GlShading& how = {});
    /// The same up to the linear picture: of who only reads that, the sensor's program need not be compiled.
    [[nodiscard]] Result<void> renderLinear(const Scene& scene, const RenderSettings& settings,
                                            const GlShading& how = {});

    [[nodiscard]] unsigned developedTexture() const; ///< RGBA8, sRGB-encoded, row 0 at the bottom: for the window
    [[nodiscard]] Image readLinear();                ///< the linear picture before the sensor
    [[nodiscard]] ViewSamples readSamples();         ///< the N and P that GL used, for GL = CPU
    void invalidateShading(); ///< the next render() shades again even if nothing changed (for timing)
    void invalidateSamples(); ///< the next render() looks again as well
    /// Of drawing what `work`, which calls render() or renderLinear(), asks for: by the driver's clock on a graphics card,
    /// by the wall where the processor draws.
    [[nodiscard]] double millisecondsOf(const std::function<void()>& work);
    void finish(); ///< waits until all drawing is done

    /// The model at given directions, in GLSL; same rows as reflectance::evaluate.
    [[nodiscard]] Result<std::vector<Vec3d>> evaluate(const Model& model, std::span<const double> values,
                                                      std::span<const Observation> rows,
                                                      const std::shared_ptr<const MeasuredTable>& table = nullptr,
                                                      LobeForm lobe = LobeForm::Conditioned);

    [[nodiscard]] const GlWork& work() const;
    [[nodiscard]] std::string description() const; ///< GL_RENDERER and GL_VERSION

private:
    struct State;
    explicit GlRenderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Whether the processor draws, by what GlRenderer::description says.
[[nodiscard]] bool isSoftware(std::string_view description);

} // namespace reflectance
