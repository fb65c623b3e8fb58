#include "core/reflectance/catalogue.h"

#include "core/base/check.h"
#include "core/base/embedded.h"
#include "core/base/text.h"
#include "core/reflectance/kernel_tables.h"
#include "core/reflectance/lists.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace reflectance {
namespace {

/// `at` counts the models that call the lobe.
std::vector<Kernels> kernelsOfOtherLobes(std::size_t at)
{
    std::vector<Kernels> all;
    for (const LobeFormFacts& facts : lobeForms().subspan(1))
        all.push_back({doubleKernels().with(facts.form)[at], floatKernels().with(facts.form)[at],
                       lanesKernels().with(facts.form)[at]});
    return all;
}

void addSpecials(Model& model)
{
    const auto rows = specialRows();
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].model == model.id())
            model.specials.emplace_back(rows[i].form, Kernels{doubleKernels().specials[i], floatKernels().specials[i],
                                                              lanesKernels().specials[i]});
}

std::vector<Model> readCatalogue()
{
    std::size_t withLobe = 0;
    std::vector<ModelText> texts;
    std::vector<Model> models;
    for (const std::string_view line : split(embeddedText("reflectance/models.txt"), '\n')) {
        if (line.empty() || line.front() == '#')
            continue;
        auto text = parseModelText(line, embeddedText("reflectance/" + std::string(line) + ".glsl"), texts);
        if (!text) { // cannot happen: the build step has parsed the same text
            std::cerr << text.error().sentence() << '\n';
            std::abort();
        }
        const std::size_t i = models.size();
        texts.push_back(*text);
        models.push_back({{doubleKernels().models[i], floatKernels().models[i], lanesKernels().models[i]},
                          *std::move(text),
                          {},
                          {},
                          {}});
        if (models.back().text.usesLobe)
            models.back().otherLobes = kernelsOfOtherLobes(withLobe++);
        addSpecials(models.back());
    }
    return models;
}

std::string rangeOf(const Parameter& p)
{
    return shortest(p.legalMin) + " .. " + shortest(p.legalMax);
}

std::vector<std::size_t> countsAllowed(const Parameter& parameter)
{
    std::vector<std::size_t> counts;
    for (const ListForm& form : parameter.forms)
        counts.push_back(form.names.size());
    if (parameter.kind == ParameterKind::Matrix)
        counts = {1, 3, 9};
    else if (parameter.kind == ParameterKind::Color)
        counts = {1, 3};
    else if (parameter.kind != ParameterKind::List)
        counts = {1};
    return counts;
}

bool takes(const Parameter& parameter, std::size_t count)
{
    const auto counts = countsAllowed(parameter);
    return std::find(counts.begin(), counts.end(), count) != counts.end();
}

/// "1 number", "1, 3 or 9 numbers"
std::string inWords(const std::vector<std::size_t>& counts)
{
    std::vector<std::string> texts;
    for (const std::size_t count : counts)
        texts.push_back(std::to_string(count));
    const std::string last = texts.back();
    texts.pop_back();
    return (texts.empty() ? last : joined(texts) + " or " + last) + (counts.back() == 1 ? " number" : " numbers");
}

std::string choicesOf(const Parameter& parameter)
{
    std::vector<std::string> texts;
    for (const double choice : parameter.choices)
        texts.push_back(shortest(choice));
    return joined(texts, " or ");
}

/// One number for a colour is grey; one or three numbers for a matrix are its diagonal.
std::vector<double> spread(const Parameter& parameter, std::span<const double> numbers)
{
    if (numbers.size() == parameter.size || parameter.kind == ParameterKind::List)
        return {numbers.begin(), numbers.end()};
    if (parameter.kind == ParameterKind::Color)
        return std::vector<double>(3, numbers[0]);
    std::vector<double> matrix(9, 0.0);
    for (std::size_t i = 0; i < 3; ++i)
        matrix[4 * i] = numbers[numbers.size() == 3 ? i : 0];
    return matrix;
}

} // namespace

const Kernels& Model::with(LobeForm form) const
{
    return form == LobeForm::Conditioned || otherLobes.empty() ? *this : otherLobes[static_cast<std::size_t>(form) - 1];
}

const Kernels& Model::with(const SpecialForm& form) const
{
    for (const auto& [special, kernels] : specials)
        if (special == form)
            return kernels;
    CHECK_EQ(form.facing, false); // the text itself would show what must be black
    return *this;
}

const std::vector<Model>& catalogue()
{
    static const std::vector<Model> models = readCatalogue();
    return models;
}

Result<const Model*> findModel(std::string_view id)
{
    std::vector<std::string> ids;
    for (const Model& model : catalogue()) {
        if (model.id() == id)
            return &model;
        ids.push_back(model.id());
    }
    return Error{"unknown model '" + std::string(id) + "'; did you mean '" + nearestName(id, ids) +
                 "'? Models: " + joined(ids)};
}

std::vector<double> valueOf(const Parameter& parameter, const ParameterValues& values)
{
    const auto found = values.find(parameter.name);
    return found != values.end() && takes(parameter, found->second.size()) ? spread(parameter, found->second)
                                                                           : parameter.initial;
}

std::vector<double> flatValues(const ModelText& model, const ParameterValues& values)
{
    std::vector<double> flat;
    flat.reserve(model.valueCount());
    for (const Parameter& parameter : model.parameters) {
        const ListForm* form = parameter.kind == ParameterKind::List ? formOf(model, parameter, values) : nullptr;
        std::vector<double> numbers = valueOf(parameter, values);
        if (form && numbers.size() != form->names.size())
            numbers = inForm(parameter, parameter.initial, *form);
        flat.insert(flat.end(), numbers.begin(), numbers.end());
        flat.resize(parameter.offset + parameter.size, 0.0);
    }
    return flat;
}

Result<std::vector<double>> checkedValue(const Parameter& parameter, std::span<const double> numbers)
{
    if (!takes(parameter, numbers.size()))
        return Error{"parameter " + parameter.name + " takes " + inWords(countsAllowed(parameter)) + ", not " +
                     std::to_string(numbers.size())};
    const auto& choices = parameter.choices;
    if (!choices.empty() && std::find(choices.begin(), choices.end(), numbers[0]) == choices.end())
        return Error{"parameter " + parameter.name + " = " + shortest(numbers[0]) + " is not among its choices; give " +
                     choicesOf(parameter)};
    for (const double number : numbers)
        if (!std::isfinite(number) || number < parameter.legalMin || number > parameter.legalMax)
            return Error{"parameter " + parameter.name + " = " + shortest(number) +
                         " is out of range; give a value in " + rangeOf(parameter)};
    return spread(parameter, numbers);
}

Result<void> setParameter(const ModelText& model, std::string_view assignment, ParameterValues& values)
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos)
        return Error{"'" + std::string(assignment) + "' is no assignment; write NAME=VALUE"};
    const std::string_view name = trimmed(assignment.substr(0, equals));
    const Parameter* parameter = model.find(name);
    if (!parameter) {
        std::vector<std::string> names;
        for (const Parameter& p : model.parameters)
            names.push_back(p.name);
        return Error{"model " + model.id + " has no parameter '" + std::string(name) + "'; did you mean '" +
                     nearestName(name, names) + "'? Parameters: " + joined(names)};
    }
    std::string list(assignment.substr(equals + 1));
    std::replace(list.begin(), list.end(), ',', ' ');
    std::vector<double> numbers;
    for (const std::string_view word : words(list)) {
        const auto number = parseNumber(word);
        if (!number)
            return Error{"parameter " + parameter->name + ": '" + std::string(word) + "' is not a number"};
        numbers.push_back(*number);
    }
    auto checked = checkedValue(*parameter, numbers);
    if (!checked)
        return checked.error();
    values[parameter->name] = *std::move(checked);
    return {};
}

} // namespace reflectance
