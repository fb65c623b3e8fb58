// Exported GLSL compiles and checks itself in OSMesa's context; what was changed is caught.
#include "core/base/text.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/render_target.h"
#include "tests/study/exports/subjects.h"

#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

class ExportedGlsl : public testing::Test {
protected:
    void SetUp() override
    {
        auto context = openHeadless(ContextKind::OsMesa);
        ASSERT_TRUE(context) << context.error().sentence();
        context_ = *std::move(context);
        auto functions = GlFunctions::load(context_->loader());
        ASSERT_TRUE(functions) << functions.error().sentence();
        functions_ = *std::move(functions);
    }

    /// What the shader's own test says; -1 where it does not compile.
    int failures(const std::string& text, const std::string& id)
    {
        const Gl& gl = functions_->gl();
        ProgramLinker linker(gl);
        const ShaderPiece stage{"stage", "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(float(" +
                                             id + "_selfTest())); }\n"};
        const auto program = GlProgram::link(linker, assembled({}, {shaderFile("gl/fullscreen.vert")}),
                                             assembled({}, {{"export", text}, stage}));
        if (!program) {
            ADD_FAILURE() << program.error().sentence();
            return -1;
        }
        RenderTarget target(gl, {GL_RGBA32F}, WithDepth::No);
        target.resize(1, 1);
        program->use();
        target.bind();
        gl.Viewport(0, 0, 1, 1);
        const GlVertexArray none(gl);
        gl.BindVertexArray(none.id());
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
        target.bindForReading(0);
        float value[4] = {-1.0F};
        gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, value);
        const auto complaint = functions_->complaint();
        EXPECT_TRUE(complaint) << complaint.error().sentence();
        return static_cast<int>(value[0]);
    }

private:
    std::unique_ptr<HeadlessContext> context_; // outlives the functions
    std::unique_ptr<GlFunctions> functions_;
};

std::vector<std::string> formulas()
{
    std::vector<std::string> ids{"own_wide"};
    for (const Model& model : catalogue())
        if (!model.text.usesTable)
            ids.push_back(model.id());
    return ids;
}

TEST_F(ExportedGlsl, HoldsForEveryModel)
{
    for (const std::string& id : formulas()) {
        const auto text = exported(subjectFor(id), ExportForm::Glsl);
        ASSERT_TRUE(text) << text.error().sentence();
        EXPECT_EQ(failures(*text, id), 0) << id;
    }
}

/// Each model with a hundredth more of its first parameter that is not 0: its expected values stay.
TEST_F(ExportedGlsl, CatchesAChangedParameterOfEveryModel)
{
    for (const std::string& id : formulas()) {
        const ExportSubject subject = subjectFor(id);
        const Parameter& first = subject.model->text.parameters.back();
        ExportSubject changed = subject;
        if (first.kind == ParameterKind::Choice)
            continue;
        for (std::size_t i = first.offset; i < first.offset + first.size; ++i)
            changed.values[i] *= 1.01;
        // The head down to the vectors from the changed model, the vectors from the good one.
        const std::string name = "const vec3 " + id + "_testN";
        const std::string good = exported(subject, ExportForm::Glsl).value();
        const std::string bad = exported(changed, ExportForm::Glsl).value();
        ASSERT_NE(bad.find(name), std::string::npos) << id;
        EXPECT_GT(failures(bad.substr(0, bad.find(name)) + good.substr(good.find(name)), id), 0) << id;
    }
}

/// Two models in one shader: no name is in the way of another.
TEST_F(ExportedGlsl, StandsBesideOthers)
{
    const std::string both = exported(subjectFor("phong"), ExportForm::Glsl).value() +
                             exported(subjectFor("hybrid"), ExportForm::Glsl).value();
    EXPECT_EQ(failures(both, "phong"), 0);
    EXPECT_EQ(failures(both, "hybrid"), 0);
}

} // namespace
} // namespace reflectance::test
