#include "core/render/gl/evaluate_pass.h"

#include "core/math/angle.h"
#include "core/render/gl/model_uniforms.h"

#include <array>

namespace reflectance {
namespace {

constexpr int gridWidth = 512;
constexpr int gridHeight = 256;
constexpr std::size_t gridPairs = static_cast<std::size_t>(gridWidth) * gridHeight;
constexpr std::array<const char*, 4> inputNames{"rowNormals", "rowViewers", "rowLights", "rowIntensities"};

void push(std::vector<float>& texels, const Vec3d& v, double w)
{
    for (const double component : {v.x, v.y, v.z, w})
        texels.push_back(static_cast<float>(component));
}

} // namespace

/// One chunk of pairs on its way to the textures: N, V, L and (I, disc), four floats each.
struct EvaluatePass::Grid {
    std::array<std::vector<float>, 4> texels;
    std::vector<std::size_t> rows; ///< of each pair
    std::vector<float> values;     ///< as read back

    void add(std::size_t row, const Vec3d& N, const Vec3d& V, const Vec3d& L, const ObservedLight& light)
    {
        push(texels[0], N, 0.0);
        push(texels[1], V, 0.0);
        push(texels[2], L, 0.0);
        push(texels[3], light.I, squaredChord(light.radius));
        rows.push_back(row);
    }
};

EvaluatePass::EvaluatePass(ProgramLinker& linker)
    : gl_(&linker.gl()), linker_(&linker), fullScreen_(*gl_),
      result_(*gl_, {GL_RGBA32F}, WithDepth::No), inputs_{GlTexture(*gl_), GlTexture(*gl_), GlTexture(*gl_),
                                                          GlTexture(*gl_)},
      table_(*gl_)
{
    result_.resize(gridWidth, gridHeight);
    for (const GlTexture& input : inputs_) {
        gl_->BindTexture(GL_TEXTURE_2D, input.id());
        gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, gridWidth, gridHeight, 0, GL_RGBA, GL_FLOAT, nullptr);
    }
}

void EvaluatePass::drawChunk(const GlProgram& program, Grid& grid, std::vector<Vec3f>& totals) const
{
    const int height = static_cast<int>((grid.rows.size() + gridWidth - 1) / gridWidth);
    const std::size_t floats = 4 * static_cast<std::size_t>(gridWidth) * static_cast<std::size_t>(height);
    for (int i = 0; i < 4; ++i) {
        const auto index = static_cast<std::size_t>(i);
        grid.texels[index].resize(floats);
        gl_->ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        gl_->BindTexture(GL_TEXTURE_2D, inputs_[index].id());
        gl_->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, gridWidth, height, GL_RGBA, GL_FLOAT, grid.texels[index].data());
        program.set(inputNames[index], i);
        grid.texels[index].clear();
    }
    result_.bind();
    gl_->Viewport(0, 0, gridWidth, height);
    fullScreen_.draw();
    grid.values.resize(floats);
    result_.bindForReading(0);
    gl_->ReadPixels(0, 0, gridWidth, height, GL_RGBA, GL_FLOAT, grid.values.data());
    for (std::size_t i = 0; i < grid.rows.size(); ++i)
        totals[grid.rows[i]] += Vec3f(grid.values[4 * i], grid.values[4 * i + 1], grid.values[4 * i + 2]);
    grid.rows.clear();
}

Result<std::vector<Vec3d>> EvaluatePass::run(const Model& model, std::span<const double> values,
                                             std::span<const Observation> rows,
                                             const std::shared_ptr<const MeasuredTable>& table, LobeForm lobe)
{
    const bool hasTable = model.text.usesTable && table;
    const auto program =
        programs_.find(model.id() + (model.walked ? model.text.file + model.text.code : "") +
                           (hasTable ? "+table" : "+") + std::string(factsOf(lobe).name),
                       [&] {
                           std::vector<ShaderPiece> pieces = modelPieces(model.text, hasTable, lobe);
                           pieces.push_back(shaderFile("gl/no_surroundings.glsl"));
                           pieces.push_back(shaderFile("gl/evaluate.frag"));
                           return GlProgram::link(*linker_, assembled({}, {shaderFile("gl/fullscreen.vert")}),
                                                  assembled({}, std::move(pieces)));
                       });
    if (!program)
        return program.error();
    (*program)->use();
    uploadParameters(**program, model.text, values);
    if (model.text.usesLobe && lobe == LobeForm::Table)
        uploadLobeTable(**program, model.text, values);
    if (hasTable)
        if (auto shown = table_.show(**program, table, static_cast<int>(inputNames.size())); !shown)
            return shown.error();
    Grid grid;
    std::vector<Vec3f> totals(rows.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const Vec3d N = normalized(rows[row].N);
        const Vec3d V = normalized(rows[row].V);
        for (const ObservedLight& light : rows[row].lights) {
            const Vec3d L = normalized(light.L);
            if (N != Vec3d() && V != Vec3d() && L != Vec3d())
                grid.add(row, N, V, L, light);
            if (grid.rows.size() == gridPairs)
                drawChunk(**program, grid, totals);
        }
    }
    if (!grid.rows.empty())
        drawChunk(**program, grid, totals);
    std::vector<Vec3d> result;
    result.reserve(totals.size());
    for (const Vec3f& total : totals)
        result.emplace_back(total);
    return result;
}

} // namespace reflectance
