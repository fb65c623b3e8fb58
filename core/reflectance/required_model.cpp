#include "core/reflectance/required_model.h"

#include "core/base/text.h"

#include <algorithm>
#include <optional>

namespace reflectance {
namespace {

struct Step {
    const Model* model;
    ParameterValues values;
};

/// The one number that a parameter holds all over: of a colour or a matrix only if it is grey.
std::optional<double> oneNumber(const Parameter& parameter, std::span<const double> numbers)
{
    const std::size_t step = parameter.kind == ParameterKind::Matrix ? 4 : 1;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] != (i % step == 0 ? numbers[0] : 0.0))
            return std::nullopt;
    return numbers[0];
}

/// "lambert_color where K=kd" read backwards: the model of which `grey` is the grey case, with a diagonal K for its colour.
std::optional<Step> colouredBrother(const Model& grey, std::string_view itsNumber, std::span<const double> color)
{
    for (const Model& model : catalogue())
        for (const DeclaredLimit& limit : model.text.becomes) {
            const std::size_t equals = limit.where.find('=');
            const Parameter* matrix = model.text.find(std::string_view(limit.where).substr(0, equals));
            if (limit.exactly && !limit.facing && limit.model == grey.id() && matrix != nullptr &&
                matrix->kind == ParameterKind::Matrix && std::string_view(limit.where).substr(equals + 1) == itsNumber)
                return Step{&model, {{matrix->name, {color.begin(), color.end()}}}};
        }
    return std::nullopt;
}

/// The other model and its values, if these values are at the limit.
std::optional<Step> atLimit(const Model& model, std::span<const double> values, const DeclaredLimit& limit)
{
    Step step{*findModel(limit.model), {}};
    const auto numbersOf = [&](const Parameter& p) { return values.subspan(p.offset, p.size); };
    for (const Parameter& shared : step.model->text.parameters)
        if (const Parameter* own = model.text.find(shared.name))
            step.values[shared.name] = {numbersOf(*own).begin(), numbersOf(*own).end()};
    std::optional<Step> instead;
    for (const std::string_view assignment : split(limit.where, ';')) {
        const std::size_t equals = assignment.find('=');
        const Parameter* own = model.text.find(assignment.substr(0, equals));
        const std::string_view right = assignment.substr(equals + 1);
        if (own == nullptr)
            return std::nullopt;
        const auto one = oneNumber(*own, numbersOf(*own));
        if (const auto number = parseNumber(right)) {
            if (!one || *one != *number)
                return std::nullopt;
        } else if (one) {
            step.values[std::string(right)] = {*one};
        } else {
            if (own->kind != ParameterKind::Color)
                return std::nullopt;
            instead = colouredBrother(*step.model, right, numbersOf(*own));
            if (!instead)
                return std::nullopt;
        }
    }
    return instead ? instead : step;
}

/// Takes the first exact limit that the values are at.
bool takeLimit(RequiredModel& required)
{
    const Model& model = *required.model;
    for (const DeclaredLimit& limit : model.text.becomes) {
        const auto step = limit.exactly ? atLimit(model, required.values, limit) : std::nullopt;
        if (!step)
            continue;
        required.leftOut.push_back(model.id() + " where " + limit.where + ": computed as " + step->model->id());
        required.form.facing = required.form.facing || limit.facing;
        required.values = flatValues(step->model->text, step->values);
        required.model = step->model;
        return true;
    }
    return false;
}

} // namespace

RequiredModel generalModel(const Model& model, std::span<const double> values)
{
    return {&model, {values.begin(), values.end()}, {}, {}};
}

RequiredModel requiredModel(const Model& model, std::span<const double> values)
{
    RequiredModel required = generalModel(model, values);
    while (takeLimit(required)) {
    }
    const bool facing = required.form.facing;
    required.form = specialFormOf(required.model->text, required.values);
    required.form.facing = facing;
    for (std::string& note : leftOutBy(required.form))
        required.leftOut.push_back(std::move(note));
    return required;
}

} // namespace reflectance
