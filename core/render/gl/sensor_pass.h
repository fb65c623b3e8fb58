// The third pass: the linear picture through the sensor into 8-bit code values, with a program made for the parts that are on.
#pragma once

#include "core/render/gl/gl_program.h"
#include "core/render/gl/render_target.h"
#include "core/render/settings.h"
#include "core/sensor/inputs.h"

namespace reflectance {

/// Of the picture: all of them, or those of which a sample sees something, while the others keep what they show.
enum class Pixels { All, Covered };

class SensorPass {
public:
    explicit SensorPass(ProgramLinker& linker);

    void resize(const RenderSettings& settings);
    /// `Covered` asks the depths that linear had at the last draw of all pixels.
    [[nodiscard]] Result<void> draw(const RenderTarget& linear, const Sensor& sensor, Pixels pixels);

    [[nodiscard]] const RenderTarget& developed() const { return developed_; }
    [[nodiscard]] std::size_t programs() const { return programs_.size(); }

private:
    [[nodiscard]] Result<const GlProgram*> programFor(const SensorInputs& inputs);
    static void setInputs(const GlProgram& program, const SensorInputs& inputs);
    void drawPicture(const RenderTarget& linear, Pixels pixels);
    void showCurve(const GlProgram& program, const Response& response);

    const Gl* gl_;
    ProgramLinker* linker_;
    GlProgramCache programs_;
    RenderTarget developed_;
    GlVertexArray noVertices_;
    GlBuffer curveBuffer_;
    GlTexture curveTexture_;
    std::shared_ptr<const ResponseCurve> curve_; ///< what is in the buffer
};

} // namespace reflectance
