#include "core/render/gl/model_uniforms.h"

#include "core/base/check.h"
#include "core/reflectance/lobe_table.h"

#include <vector>

namespace reflectance {

namespace {

/// As the special form takes it.
void uploadMatrix(const GlProgram& program, const char* name, const std::vector<float>& rows, MatrixForm form)
{
    if (form == MatrixForm::Full)
        program.setRows(name, rows.data());
    else if (form == MatrixForm::Diagonal)
        program.set(name, Vec3d(rows[0], rows[4], rows[8]));
    else if (form == MatrixForm::Grey)
        program.set(name, rows[0]);
}

} // namespace

void uploadParameters(const GlProgram& program, const ModelText& model, std::span<const double> values,
                      const SpecialForm& form)
{
    CHECK_EQ(values.size(), model.valueCount());
    for (const Parameter& parameter : model.parameters) {
        const auto numbers = values.subspan(parameter.offset, parameter.size);
        const std::vector<float> rounded(numbers.begin(), numbers.end());
        const char* name = parameter.name.c_str();
        switch (parameter.kind) {
        case ParameterKind::Number:
            program.set(name, rounded[0]);
            break;
        case ParameterKind::Color:
            if (parameter.name == "ks" && form.ks == ColorForm::One)
                program.set(name, rounded[0]);
            else
                program.set(name, Vec3d(numbers[0], numbers[1], numbers[2]));
            break;
        case ParameterKind::Matrix:
            uploadMatrix(program, name, rounded, form.K);
            break;
        case ParameterKind::Choice:
            program.set(name, static_cast<int>(numbers[0]));
            break;
        case ParameterKind::List:
            program.set(name, rounded);
            break;
        }
    }
}

void uploadLobeTable(const GlProgram& program, const ModelText& model, std::span<const double> values)
{
    const Parameter* n = model.find("n");
    CHECK_EQ(n != nullptr, true);
    const LobeTable<double> table = makeLobeTable(values[n->offset]);
    const std::vector<float> rounded(table.values.begin(), table.values.end());
    program.set("lobeTable", rounded);
    program.set("lobeTableScale", static_cast<float>(table.scale));
}

} // namespace reflectance
