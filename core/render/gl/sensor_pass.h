// The third pass: the linear picture through the sensor into 8-bit code values, with a program made for the parts that are on.
#pragma once

#include "core/render/gl/full_screen.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/render_target.h"
#include "core/render/settings.h"
#include "core/sensor/inputs.h"

#include <optional>

namespace reflectance {

class SensorPass {
public:
    explicit SensorPass(ProgramLinker& linker);

    void resize(const RenderSettings& settings);
    /// Other pixels see something than at the last draw.
    void samplesChanged() { around_.reset(); }
    /// `around`: the radiance in all pixels that see nothing by the depths of `linear`; none where it is not one.
    [[nodiscard]] Result<void> draw(const RenderTarget& linear, const Sensor& sensor,
                                    const std::optional<Vec3d>& around);

    [[nodiscard]] const RenderTarget& developed() const { return developed_; }
    [[nodiscard]] std::size_t programs() const { return programs_.size(); }

private:
    /// What pixels show that see nothing.
    struct Around {
        Sensor sensor;
        Vec3d radiance;

        friend bool operator==(const Around&, const Around&) = default;
    };

    [[nodiscard]] Result<const GlProgram*> programFor(const SensorInputs& inputs);
    static void setInputs(const GlProgram& program, const SensorInputs& inputs);
    void drawPicture(const RenderTarget& linear, const std::optional<Around>& around, bool alikeEverywhere);
    void paint(const Around& around) const;
    void showCurve(const GlProgram& program, const Response& response);

    const Gl* gl_;
    ProgramLinker* linker_;
    GlProgramCache programs_;
    RenderTarget developed_;
    std::optional<Around> around_;
    FullScreen fullScreen_;
    GlBuffer curveBuffer_;
    GlTexture curveTexture_;
    std::shared_ptr<const ResponseCurve> curve_; ///< what is in the buffer
};

} // namespace reflectance
