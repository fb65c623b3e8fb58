// The second pass: shades the kept samples over the whole picture, with a program made for what the scene requires.
#pragma once

#include "core/geometry/camera.h"
#include "core/render/gl/environment_map.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/light_texels.h"
#include "core/render/gl/render_target.h"
#include "core/render/gl/shading_inputs.h"
#include "core/render/gl/table_buffer.h"
#include "core/render/gl/visibility_pass.h"
#include "core/render/settings.h"

namespace reflectance {

class ShadingPass {
public:
    explicit ShadingPass(ProgramLinker& linker);

    void resize(const RenderSettings& settings);
    /// The next draw has other samples than the last one.
    void samplesChanged() { covered_ = false; }

    /// Draws into linear(). What was seen must be that of this camera and these settings.
    [[nodiscard]] Result<void> draw(const VisibilityPass& seen, const ShadingInputs& inputs, const Camera& camera,
                                    const RenderSettings& settings);

    /// RGB: mean linear radiance, A: coverage.
    [[nodiscard]] const RenderTarget& linear() const { return linear_; }
    [[nodiscard]] std::size_t programs() const { return programs_.size(); }
    [[nodiscard]] std::uint64_t tableUploads() const { return table_.uploads(); }
    /// Of lights, tables and surroundings.
    [[nodiscard]] std::uint64_t uploadedBytes() const
    {
        return lightBytes_ + table_.uploadedBytes() + environmentMap_.uploadedBytes();
    }

private:
    [[nodiscard]] Result<const GlProgram*> programFor(const Requirements& requirements, Place place);
    [[nodiscard]] Result<void> cover(const RenderTarget& samples, const RenderSettings& settings);
    void keepIn(bool halfBuffer);
    void drawPicture() const;
    void drawCovered(const Vec3d& background) const;
    void setLights(const GlProgram& program, const std::vector<float>& texels);
    [[nodiscard]] Result<void> setEnvironment(const GlProgram& program, const ShadingInputs& inputs);

    const Gl* gl_;
    ProgramLinker* linker_;
    RenderTarget linear_;
    bool halfBuffer_ = false; ///< of linear_
    bool covered_ = false;    ///< the depths of linear_ tell which pixels see something
    GlVertexArray noVertices_;
    LightBuffer lights_;
    EnvironmentMap environmentMap_;
    TableBuffer table_;
    GlProgramCache programs_;
    std::vector<float> uploadedLights_;
    std::uint64_t lightBytes_ = 0;
};

} // namespace reflectance
