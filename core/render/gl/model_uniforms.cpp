#include "core/render/gl/model_uniforms.h"

#include "core/base/check.h"

#include <algorithm>

namespace reflectance {

void uploadParameters(const GlProgram& program, const ModelText& model, std::span<const double> values)
{
    CHECK_EQ(values.size(), model.valueCount());
    for (const Parameter& parameter : model.parameters) {
        const double* first = values.data() + parameter.offset;
        const char* name = parameter.name.c_str();
        if (parameter.kind == ParameterKind::Number) {
            program.set(name, static_cast<float>(*first));
        } else if (parameter.kind == ParameterKind::Color) {
            program.set(name, Vec3d(first[0], first[1], first[2]));
        } else {
            std::array<float, 9> rows{};
            std::transform(first, first + 9, rows.begin(), [](double v) { return static_cast<float>(v); });
            program.setRows(name, rows);
        }
    }
}

} // namespace reflectance
