// The second pass: shades the kept samples over the whole picture, with a program made for what the scene requires.
#pragma once

#include "core/geometry/camera.h"
#include "core/render/gl/environment_map.h"
#include "core/render/gl/full_screen.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/light_texels.h"
#include "core/render/gl/render_target.h"
#include "core/render/gl/shading_inputs.h"
#include "core/render/gl/table_buffer.h"
#include "core/render/gl/visibility_pass.h"
#include "core/render/settings.h"

#include <optional>

namespace reflectance {

class ShadingPass {
public:
    explicit ShadingPass(ProgramLinker& linker);

    /// For what `seen`, which was resized before and stays where it is, sees of so many samples.
    void resize(const RenderSettings& settings, const VisibilityPass& seen);
    /// The next draw has other samples than the last one.
    void samplesChanged();

    /// Draws into linear(). What was seen must be that of this camera and these settings.
    [[nodiscard]] Result<void> draw(const VisibilityPass& seen, const ShadingInputs& inputs, const Camera& camera,
                                    const RenderSettings& settings);

    /// RGB: mean linear radiance, A: coverage. Its depths are those of a cleared target where no sample sees anything, unless
    /// the surroundings show there.
    [[nodiscard]] const RenderTarget& linear() const { return linear_; }
    /// What stands in all pixels that see nothing; none where the surroundings show, or where it was rounded to half floats.
    [[nodiscard]] std::optional<Vec3d> around() const { return halfBuffer_ ? std::nullopt : around_; }
    [[nodiscard]] std::uint64_t bytes() const { return linear_.bytes() + coverage_.bytes(); }
    [[nodiscard]] std::size_t programs() const { return programs_.size(); }
    [[nodiscard]] std::uint64_t tableUploads() const { return table_.uploads(); }
    /// Of lights, tables and surroundings.
    [[nodiscard]] std::uint64_t uploadedBytes() const
    {
        return lightBytes_ + table_.uploadedBytes() + environmentMap_.uploadedBytes();
    }

private:
    [[nodiscard]] Result<const GlProgram*> programFor(const Requirements& requirements, Place place);
    [[nodiscard]] Result<void> cover(const RenderTarget& triangles);
    void keepIn(bool halfBuffer);
    void drawCovered(const Vec3d& background);
    void setLights(const GlProgram& program, const std::vector<float>& texels);
    [[nodiscard]] Result<void> setEnvironment(const GlProgram& program, const ShadingInputs& inputs);

    const Gl* gl_;
    ProgramLinker* linker_;
    RenderTarget linear_;
    bool halfBuffer_ = false; ///< of linear_
    RenderTarget coverage_;   ///< of pixels with several samples: depths that tell which of them see something
    int samplesPerAxis_ = 1;
    bool covered_ = false;        ///< the depths of linear_ are those of these samples
    std::optional<Vec3d> around_; ///< the colour that stands in all pixels that see nothing
    FullScreen fullScreen_;
    LightBuffer lights_;
    EnvironmentMap environmentMap_;
    TableBuffer table_;
    GlProgramCache programs_;
    std::vector<float> uploadedLights_;
    std::uint64_t lightBytes_ = 0;
};

} // namespace reflectance
