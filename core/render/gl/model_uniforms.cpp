#include "core/render/gl/model_uniforms.h"

#include "core/base/check.h"
#include "core/reflectance/lobe_table.h"

#include <vector>

namespace reflectance {

void uploadParameters(const GlProgram& program, const ModelText& model, std::span<const double> values)
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
            program.set(name, Vec3d(numbers[0], numbers[1], numbers[2]));
            break;
        case ParameterKind::Matrix:
            program.setRows(name, rounded.data());
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
