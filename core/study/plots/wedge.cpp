#include "core/base/text.h"
#include "core/study/plots/balls.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

std::vector<double> stepsOf(const Parameter& parameter, int count)
{
    Axis axis{"", parameter.sliderMin, parameter.sliderMax};
    if (parameter.logarithmic && parameter.sliderMin > 0.0)
        axis.scale = AxisScale::Log;
    std::vector<double> steps;
    for (int k = 0; k < count; ++k)
        steps.push_back(valueAlong(axis, count > 1 ? k / (count - 1.0) : 0.0));
    return steps;
}

} // namespace

std::vector<const Parameter*> wedgeParameters(const ModelText& model)
{
    std::vector<const Parameter*> found;
    for (const Parameter& parameter : model.parameters)
        if (parameter.kind == ParameterKind::Number || parameter.kind == ParameterKind::Color)
            found.push_back(&parameter);
    return found;
}

std::vector<NamedSurface> wedgeOf(const NamedSurface& surface, const Parameter& parameter, int count)
{
    std::vector<NamedSurface> wedge;
    for (const double value : stepsOf(parameter, count)) {
        NamedSurface step = surface;
        step.name = parameter.name + " = " + general(value, 3);
        std::fill_n(step.values.begin() + static_cast<std::ptrdiff_t>(parameter.offset), parameter.size, value);
        wedge.push_back(std::move(step));
    }
    return wedge;
}

} // namespace reflectance
