#include "core/reflectance/lists.h"

#include "core/base/text.h"

#include <algorithm>

namespace reflectance {
namespace {

/// As it was named, whatever its count.
const std::vector<double>& named(const Parameter& parameter, const ParameterValues& values)
{
    const auto found = values.find(parameter.name);
    return found == values.end() || found->second.empty() ? parameter.initial : found->second;
}

} // namespace

const ListForm* formOf(const ModelText& model, const Parameter& list, const ParameterValues& values)
{
    return list.formFor(named(*model.find(list.chosenBy), values).front());
}

std::vector<double> inForm(const Parameter& list, std::span<const double> numbers, const ListForm& form)
{
    std::vector<double> result(form.names.size(), 0.0);
    const auto fits = [&](const ListForm& f) { return f.names.size() == numbers.size(); };
    const auto before = std::find_if(list.forms.begin(), list.forms.end(), fits);
    if (before == list.forms.end())
        return result;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const auto same = std::find(before->names.begin(), before->names.end(), form.names[i]);
        if (same != before->names.end())
            result[i] = numbers[static_cast<std::size_t>(same - before->names.begin())];
    }
    return result;
}

Result<void> checkLists(const ModelText& model, const ParameterValues& values)
{
    for (const Parameter& parameter : model.parameters) {
        if (parameter.kind != ParameterKind::List)
            continue;
        const ListForm* form = formOf(model, parameter, values);
        const std::size_t count = named(parameter, values).size();
        if (!form || form->names.size() == count)
            continue;
        return Error{"parameter " + parameter.name + " holds " + std::to_string(count) + " numbers, and " +
                     parameter.chosenBy + " = " + shortest(form->choice) + " takes " +
                     std::to_string(form->names.size()) + "; set both so that they agree"};
    }
    return {};
}

ParameterValues valuesByName(const ModelText& model, std::span<const double> flat)
{
    ParameterValues values;
    for (const Parameter& p : model.parameters) {
        const auto numbers = flat.subspan(p.offset, p.size);
        std::vector<double>& kept = values[p.name];
        kept.assign(numbers.begin(), numbers.end());
        if (p.kind == ParameterKind::List)
            if (const ListForm* form = formOf(model, p, values))
                kept.resize(form->names.size());
    }
    return values;
}

} // namespace reflectance
