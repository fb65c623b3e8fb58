#include "core/study/fit/variables.h"

#include "core/reflectance/lists.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

constexpr const char* channelNames[] = {" red", " green", " blue"};
/// A logarithmic parameter ends this far below its slider: 0 has no logarithm, and nothing changes any more down there.
constexpr double logFloor = 1e-3;

Variable variableFor(const Parameter& parameter, std::string name, std::vector<std::size_t> slots)
{
    Variable variable;
    variable.name = std::move(name);
    variable.slots = std::move(slots);
    for (std::size_t& slot : variable.slots)
        slot += parameter.offset;
    variable.isShape = parameter.kind == ParameterKind::Number;
    variable.logarithmic = parameter.logarithmic && parameter.sliderMin > 0.0;
    const double least = variable.logarithmic ? logFloor * parameter.sliderMin : parameter.legalMin;
    variable.low = variable.fromValue(std::max(least, parameter.legalMin));
    variable.high = variable.fromValue(parameter.legalMax);
    variable.usualLow = variable.fromValue(parameter.sliderMin);
    variable.usualHigh = variable.fromValue(parameter.sliderMax);
    return variable;
}

void addColor(const Parameter& p, bool isGrey, std::vector<Variable>& variables)
{
    if (isGrey)
        return variables.push_back(variableFor(p, p.name, {0, 1, 2}));
    for (std::size_t c = 0; c < 3; ++c)
        variables.push_back(variableFor(p, p.name + channelNames[c], {c}));
}

/// The numbers that count for the list's choice, each by its name.
/// Whether all nine numbers are turned, and not the diagonal alone.
bool isWhole(const Parameter& matrix, ObservedForm form, const std::set<std::string>& grey)
{
    return form == ObservedForm::Matrix && !grey.contains(matrix.name);
}

void addMatrix(const Parameter& p, bool isGrey, bool whole, std::vector<Variable>& variables)
{
    if (isGrey)
        return variables.push_back(variableFor(p, p.name, {0, 4, 8}));
    for (std::size_t i = 0; i < 9; ++i)
        if (whole || i % 4 == 0)
            variables.push_back(
                variableFor(p, p.name + " " + std::to_string(i / 3 + 1) + " " + std::to_string(i % 3 + 1), {i}));
}

/// One variable for each number that counts.
void addList(const Parameter& p, const ListForm* form, std::vector<Variable>& variables)
{
    for (std::size_t i = 0; form && i < form->names.size(); ++i)
        variables.push_back(variableFor(p, p.name + " " + form->names[i], {i}));
}

} // namespace

double Variable::fromValue(double value) const
{
    return logarithmic ? std::log(value) : value;
}

double Variable::toValue(double u) const
{
    return logarithmic ? std::exp(u) : u;
}

double Variable::derivative(double u) const
{
    return logarithmic ? std::exp(u) : 1.0;
}

std::vector<Variable> variablesOf(const ModelText& model, ObservedForm form, const ParameterValues& fixed,
                                  const std::set<std::string>& grey)
{
    std::vector<Variable> variables;
    for (const Parameter& p : model.parameters) {
        if (fixed.contains(p.name))
            continue;
        const bool isGrey = form == ObservedForm::Grey || grey.contains(p.name);
        if (p.kind == ParameterKind::Number)
            variables.push_back(variableFor(p, p.name, {0}));
        else if (p.kind == ParameterKind::Color)
            addColor(p, isGrey, variables);
        else if (p.kind == ParameterKind::Matrix)
            addMatrix(p, isGrey, isWhole(p, form, grey), variables);
        else if (p.kind == ParameterKind::List)
            addList(p, formOf(model, p, fixed), variables);
    }
    return variables;
}

std::vector<double> valuesAround(const ModelText& model, ObservedForm form, const ParameterValues& fixed,
                                 const std::set<std::string>& grey)
{
    std::vector<double> flat = flatValues(model, fixed);
    for (const Parameter& p : model.parameters)
        if (p.kind == ParameterKind::Matrix && !fixed.contains(p.name) && !isWhole(p, form, grey))
            for (std::size_t i = 0; i < 9; ++i)
                if (i % 4 != 0)
                    flat[p.offset + i] = 0.0;
    return flat;
}

void put(const std::vector<Variable>& variables, const double* u, std::vector<double>& flat)
{
    for (std::size_t j = 0; j < variables.size(); ++j) {
        const Variable& variable = variables[j];
        for (const std::size_t slot : variable.slots)
            flat[slot] = variable.toValue(std::clamp(u[j], variable.low, variable.high));
    }
}

ParameterValues namedValues(const ModelText& model, const std::vector<double>& flat)
{
    return valuesByName(model, flat);
}

} // namespace reflectance
