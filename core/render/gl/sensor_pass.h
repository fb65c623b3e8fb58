// The third pass: the linear picture through the sensor into 8-bit code values.
#pragma once

#include "core/render/gl/gl_program.h"
#include "core/render/gl/render_target.h"
#include "core/render/settings.h"
#include "core/sensor/sensor.h"

namespace reflectance {

class SensorPass {
public:
    [[nodiscard]] static Result<SensorPass> create(const Gl& gl);

    void resize(const RenderSettings& settings);
    void draw(const RenderTarget& linear, const Sensor& sensor);

    [[nodiscard]] const RenderTarget& developed() const { return developed_; }

private:
    SensorPass(const Gl& gl, GlProgram program);
    void setInputs(const Sensor& sensor) const;
    void showCurve(const Response& response);

    const Gl* gl_;
    GlProgram program_;
    RenderTarget developed_;
    GlVertexArray noVertices_;
    GlBuffer curveBuffer_;
    GlTexture curveTexture_;
    std::shared_ptr<const ResponseCurve> curve_; ///< what is in the buffer
};

} // namespace reflectance
