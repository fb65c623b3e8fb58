// A model at given directions, in GLSL: (row, light) pairs are laid out in float textures and shaded by one pass.
#pragma once

#include "core/reflectance/catalogue.h"
#include "core/reflectance/observation.h"
#include "core/render/gl/full_screen.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/render_target.h"
#include "core/render/gl/table_buffer.h"

#include <memory>
#include <span>
#include <vector>

namespace reflectance {

class EvaluatePass {
public:
    explicit EvaluatePass(ProgramLinker& linker);

    /// As reflectance::evaluate: directions are normalised in double and rounded once, then all is float, the sum over
    /// a row's lights too.
    [[nodiscard]] Result<std::vector<Vec3d>> run(const Model& model, std::span<const double> values,
                                                 std::span<const Observation> rows,
                                                 const std::shared_ptr<const MeasuredTable>& table, LobeForm lobe);

    [[nodiscard]] std::size_t programs() const { return programs_.size(); }

private:
    struct Grid;

    void drawChunk(const GlProgram& program, Grid& grid, std::vector<Vec3f>& totals) const;

    const Gl* gl_;
    ProgramLinker* linker_;
    FullScreen fullScreen_;
    RenderTarget result_;
    GlTexture inputs_[4];
    TableBuffer table_;
    GlProgramCache programs_;
};

} // namespace reflectance
